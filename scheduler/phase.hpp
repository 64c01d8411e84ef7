#pragma once

#include <functional>
#include <string>
#include <vector>

namespace pliant::scheduler {

using FieldId = int;
using BlockId = int;

/// Which blocks' values of a field an access touches, seen from the block that a phase works on.
enum class Reach { own, neighbours, all };

/// A field that a phase reads or writes, one value for each block.
struct Access {
  FieldId field;
  Reach reach = Reach::own;
};

/// One part of a step, with everything that it touches.
///
/// A step behaves as if its phases ran one after another in the order of their list. Within a phase
/// the blocks run in any order, so no block may write what another block of the same phase touches.
struct Phase {
  enum class Extent { per_block, once };

  std::string name;  ///< phases of one name, one for each stage, share a timer
  int stage = -1;    ///< -1: not part of a stage; else shown as name[stage]
  std::vector<Access> reads = {};
  std::vector<Access> writes = {};  ///< Reach::own or Reach::all
  Extent extent = Extent::per_block;
  std::vector<BlockId> blocks = {};  ///< per_block: where there is work; empty means every block
  std::function<void(BlockId)> run;  ///< a `once` phase gets block 0, and Reach::own means block 0
};

/// name, or name[stage].
std::string label(const Phase& phase);

}  // namespace pliant::scheduler

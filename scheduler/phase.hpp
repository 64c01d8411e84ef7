#pragma once

#include <functional>
#include <string>
#include <vector>

namespace pliant::scheduler {

using FieldId = int;
using BlockId = int;

/// Which blocks' values of a field an access includes, seen from the block that a phase works on.
enum class Reach { own, neighbours, all };

/// A field that a phase reads or writes, one value for each block.
struct Access {
  FieldId field;
  Reach reach = Reach::own;
};

/// One part of a step, with all fields that it reads and writes.
///
/// A step behaves as if its phases ran one after another in the order of their list. Within a phase
/// the blocks run in any order, so no block may write what another block of the same phase
/// accesses.
struct Phase {
  /// What a phase is to blocks that live in several processes.
  ///
  ///     per_block  runs once for each block, in the process that owns the block
  ///     reduce     runs once for all blocks, and folds their values in the order of the blocks;
  ///                every process knows the outcome
  ///     exchange   sends the fields that it reads to the processes that own neighbouring blocks
  ///                (to all processes where it reads with Reach::all). In one process it does
  ///                nothing, and the graph has no node for it.
  enum class Kind { per_block, reduce, exchange };

  std::string name;  ///< phases of one name, one for each stage, share a timer
  int stage = -1;    ///< -1: not part of a stage; else shown as name[stage]
  std::vector<Access> reads = {};
  std::vector<Access> writes = {};  ///< Reach::own or Reach::all
  Kind kind = Kind::per_block;
  std::vector<BlockId> blocks = {};  ///< per_block: where there is work; empty means every block
  /// Called with the block, with 0 in a reduce phase, where Reach::own means block 0 too; an
  /// exchange has none.
  std::function<void(BlockId)> run;
};

/// name, or name[stage].
std::string label(const Phase& phase);

}  // namespace pliant::scheduler

#pragma once

#include <functional>
#include <string>
#include <vector>

namespace pliant::scheduler {

using FieldId = int;
using BlockId = int;

/// The blocks whose values of a field an access includes, relative to the block of the phase.
enum class Reach { own, neighbours, all };

/// A field that a phase reads or writes; it has one value for each block.
struct Access {
  FieldId field;
  Reach reach = Reach::own;
};

/// One part of a step, with all fields that it reads and writes.
///
/// A step behaves as if its phases ran one after another in the order of their list. The blocks of
/// a phase run in any order, so no block may write what another block of the same phase accesses.
struct Phase {
  /// How a phase treats blocks that belong to several processes.
  ///
  ///     per_block  runs once for each block, in the process that owns the block
  ///     reduce     runs once for all blocks, and combines their values in the order of the blocks;
  ///                every process has the result
  ///     exchange   sends the fields that it reads to the processes that own neighbouring blocks
  ///                (to all processes if it reads with Reach::all). With one process it does
  ///                nothing, and the graph has no node for it.
  enum class Kind { per_block, reduce, exchange };

  std::string name;  ///< phases with the same name, one for each stage, share a timer
  int stage = -1;    ///< -1: not part of a stage; else printed as name[stage]
  std::vector<Access> reads = {};
  std::vector<Access> writes = {};  ///< Reach::own or Reach::all
  Kind kind = Kind::per_block;
  std::vector<BlockId> blocks = {};  ///< per_block: blocks that have work; empty means every block
  /// Called with the block. A reduce phase is called with 0, and its Reach::own means block 0; an
  /// exchange has no function.
  std::function<void(BlockId)> run;
};

/// name, or name[stage].
std::string label(const Phase& phase);

}  // namespace pliant::scheduler

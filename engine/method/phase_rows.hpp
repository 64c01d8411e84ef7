#pragma once

#include <functional>
#include <numeric>
#include <utility>
#include <vector>

#include "engine/method/resources.hpp"
#include "scheduler/phase.hpp"

namespace pliant {

/// Writes a list of phases like the algorithm box of the paper: one row for each phase, with its
/// name, what it reads, what it writes, and its function.
class PhaseRows {
 public:
  explicit PhaseRows(std::vector<scheduler::Phase>& phases) : phases_(phases) {}

  /// Rows of one body, which numbers its blocks from 0; the step graph numbers those of all bodies.
  PhaseRows(std::vector<scheduler::Phase>& phases, int first_block, std::size_t block_count)
      : phases_(phases), first_block_(first_block), blocks_(block_count) {
    std::iota(blocks_.begin(), blocks_.end(), first_block);
  }

  /// Rows for some of the blocks.
  PhaseRows(std::vector<scheduler::Phase>& phases, std::vector<int> blocks)
      : phases_(phases), blocks_(std::move(blocks)) {}

  /// Sets the stage of a step, or the pass of an algorithm, of the next rows.
  PhaseRows& at_stage(int stage) {
    stage_ = stage;
    return *this;
  }

  /// Calls `run(block)` for each block.
  void each(const char* name, const Accesses& reads, const Accesses& writes,
            std::function<void(int)> run) {
    phases_.push_back(
        {.name = name,
         .stage = stage_,
         .reads = reads,
         .writes = writes,
         .blocks = blocks_,
         .run = [run = std::move(run), first = first_block_](int block) { run(block - first); }});
  }

  /// Calls `run()` once for all blocks.
  void reduce(const char* name, const Accesses& reads, const Accesses& writes,
              std::function<void()> run) {
    phases_.push_back({.name = name,
                       .stage = stage_,
                       .reads = reads,
                       .writes = writes,
                       .kind = scheduler::Phase::Kind::reduce,
                       .run = [run = std::move(run)](int) { run(); }});
  }

 private:
  std::vector<scheduler::Phase>& phases_;
  int first_block_ = 0, stage_ = -1;
  std::vector<int> blocks_;
};

}  // namespace pliant

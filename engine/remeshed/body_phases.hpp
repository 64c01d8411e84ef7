#pragma once

#include <functional>
#include <numeric>
#include <vector>

#include "scheduler/phase.hpp"

namespace pliant::remeshed {

/// Adds phases of one body to those of all: the step graph numbers the blocks of all bodies, the
/// body its own from 0.
class BodyPhases {
 public:
  using Accesses = std::vector<scheduler::Access>;

  BodyPhases(std::vector<scheduler::Phase>& phases, int first_block, std::size_t block_count)
      : phases_(phases), first_block_(first_block), blocks_(block_count) {
    std::iota(blocks_.begin(), blocks_.end(), first_block);
  }

  /// `run(block)` of each block.
  void each(const char* name, Accesses reads, Accesses writes, std::function<void(int)> run,
            int stage = -1) {
    phases_.push_back(
        {.name = name,
         .stage = stage,
         .reads = std::move(reads),
         .writes = std::move(writes),
         .blocks = blocks_,
         .run = [run = std::move(run), first = first_block_](int b) { run(b - first); }});
  }

  void reduce(const char* name, Accesses reads, Accesses writes, std::function<void()> run) {
    phases_.push_back({.name = name,
                       .reads = std::move(reads),
                       .writes = std::move(writes),
                       .kind = scheduler::Phase::Kind::reduce,
                       .run = [run = std::move(run)](int) { run(); }});
  }

 private:
  std::vector<scheduler::Phase>& phases_;
  int first_block_;
  std::vector<int> blocks_;
};

}  // namespace pliant::remeshed

#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scheduler/blocks.hpp"
#include "scheduler/phase.hpp"

/// Shorthands for phases and blocks.
namespace pliant::scheduler::testing {

inline void do_nothing(BlockId) {}

inline Phase per_block(std::string name, std::vector<Access> reads, std::vector<Access> writes,
                       std::function<void(BlockId)> run = do_nothing) {
  return {.name = std::move(name),
          .reads = std::move(reads),
          .writes = std::move(writes),
          .blocks = {},
          .run = std::move(run)};
}

inline Phase reduce(std::string name, std::vector<Access> reads, std::vector<Access> writes,
                    std::function<void(BlockId)> run = do_nothing) {
  Phase phase = per_block(std::move(name), std::move(reads), std::move(writes), std::move(run));
  phase.kind = Phase::Kind::reduce;
  return phase;
}

/// Blocks in a row: 0 - 1 - 2 - ...
inline Blocks row_of_blocks(int count) {
  Blocks blocks;
  blocks.neighbours.resize(static_cast<std::size_t>(count));
  for (int b = 0; b + 1 < count; ++b) {
    blocks.neighbours[static_cast<std::size_t>(b)].push_back(b + 1);
    blocks.neighbours[static_cast<std::size_t>(b) + 1].push_back(b);
  }
  return blocks;
}

}  // namespace pliant::scheduler::testing

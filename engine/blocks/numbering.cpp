#include "engine/blocks/numbering.hpp"

namespace pliant {

void number_blocks(std::span<const int> counts, std::vector<BlockOwner>& owners) {
  owners.clear();
  for (std::size_t body = 0; body < counts.size(); ++body) {
    for (int b = 0; b < counts[body]; ++b) owners.push_back({static_cast<int>(body), b});
  }
}

scheduler::Blocks join_blocks(std::span<const scheduler::Blocks> bodies) {
  scheduler::Blocks all;
  for (const scheduler::Blocks& body : bodies) {
    const int first = all.count();
    for (std::vector<int> near : body.neighbours) {
      for (int& b : near) b += first;
      all.neighbours.push_back(std::move(near));
    }
  }
  return all;
}

}  // namespace pliant

#include "engine/blocks/numbering.hpp"

namespace pliant {

void number_blocks(int body, int count, std::vector<BlockOwner>& owners) {
  for (int block = 0; block < count; ++block) owners.push_back({body, block});
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

#include "engine/blocks/numbering.hpp"

namespace pliant {

template <int D>
void number_blocks(const Layouts<D>& layouts, std::vector<BlockOwner>& owners) {
  owners.clear();
  for (std::size_t body = 0; body < layouts.size(); ++body) {
    const int count = static_cast<int>(layouts[body]->blocks().size());
    for (int b = 0; b < count; ++b) owners.push_back({static_cast<int>(body), b});
  }
}

template <int D>
scheduler::Blocks connect_blocks(const Layouts<D>& layouts, int more) {
  scheduler::Blocks blocks;
  for (const Layout<D>* layout : layouts) {
    const int first = blocks.count();
    for (auto& near : layout->neighbours_and(more)) {
      for (int& b : near) b += first;
      blocks.neighbours.push_back(std::move(near));
    }
  }
  return blocks;
}

template void number_blocks<2>(const Layouts<2>&, std::vector<BlockOwner>&);
template scheduler::Blocks connect_blocks<2>(const Layouts<2>&, int);
template void number_blocks<3>(const Layouts<3>&, std::vector<BlockOwner>&);
template scheduler::Blocks connect_blocks<3>(const Layouts<3>&, int);

}  // namespace pliant

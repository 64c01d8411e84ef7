#include "engine/lattice/layout_blocks.hpp"

namespace pliant {

template <int D>
void number_blocks(const Layouts<D>& layouts, std::vector<BlockOwner>& owners) {
  owners.clear();
  for (std::size_t body = 0; body < layouts.size(); ++body) {
    number_blocks(static_cast<int>(body), static_cast<int>(layouts[body]->blocks().size()), owners);
  }
}

template <int D>
scheduler::Blocks connect_blocks(const Layouts<D>& layouts, int more) {
  std::vector<scheduler::Blocks> bodies;
  for (const Layout<D>* layout : layouts) bodies.push_back({layout->neighbours_and(more)});
  return join_blocks(bodies);
}

template void number_blocks<2>(const Layouts<2>&, std::vector<BlockOwner>&);
template scheduler::Blocks connect_blocks<2>(const Layouts<2>&, int);
template void number_blocks<3>(const Layouts<3>&, std::vector<BlockOwner>&);
template scheduler::Blocks connect_blocks<3>(const Layouts<3>&, int);

}  // namespace pliant

#include "engine/remeshed/remeshing/moving_lattice.hpp"

#include <algorithm>

namespace pliant::remeshed {

namespace {

template <class T, int D>
Point<D> middle_of_particles(const Body<T, D>& body) {
  Point<D> sum = {};
  std::int64_t count = 0;
  const Layout<D>& layout = body.population.layout;
  for (const Block<D>& block : layout.blocks()) {
    layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
      if (body.population.kind[p] != Kind::interior) return;
      ++count;
      const Point<D> node = body.lattice.node(cell);
      for (int a = 0; a < D; ++a) sum[a] += node[a] + body.stage[0].get(Field::drift, a)[p];
    });
  }
  for (double& component : sum) component /= static_cast<double>(std::max<std::int64_t>(count, 1));
  return sum;
}

template <class T, int D>
void move_lattice(Body<T, D>& body, const Point<D>& by) {
  for (int a = 0; a < D; ++a) {
    body.lattice.origin[a] += by[a];
    T* const drift = body.stage[0].get(Field::drift, a);
    T* const carried = body.stage[0].get(Field::displacement, a);
    for (std::int64_t p = 0; p < body.population.layout.slots(); ++p) {
      drift[p] = static_cast<T>(drift[p] - by[a]);
      carried[p] = static_cast<T>(carried[p] + by[a]);
    }
  }
  // Heights above walls are relative to the former nodes.
  for (BlockGhosts<T, D>& ghosts : body.population.ghosts) {
    for (std::size_t k = 0; k < ghosts.contact.size(); ++k) {
      for (int a = 0; a < D; ++a) {
        ghosts.contact_height[k] += ghosts.normal[ghosts.contact[k]][a] * by[a];
      }
    }
  }
}

}  // namespace

template <class T, int D>
void move_lattices(State<T, D>& state) {
  const std::vector<Wall<D>>& walls = state.boundaries.walls;
  if (std::ranges::any_of(walls, [](const Wall<D>& wall) { return wall.is_attached(); })) return;
  const auto& former = state.remeshed_poses;
  const bool rest = std::ranges::equal(
      walls, former,
      [](const Wall<D>& wall, const WallPose<D>& was) { return wall.pose().offset == was.offset; });
  if (rest) return;
  for (Body<T, D>& body : state.bodies) {
    const int wall = state.boundaries.nearest_contact(middle_of_particles(body)).first;
    Point<D> by = {};
    for (int a = 0; a < D; ++a) {
      const bool is_fixed = body.lattice.period[a] != 0;
      by[a] = is_fixed ? 0 : walls[wall].pose().offset[a] - former[wall].offset[a];
    }
    if (by != Point<D>{}) move_lattice<T, D>(body, by);
  }
}

template void move_lattices<double, 2>(State<double, 2>&);
template void move_lattices<double, 3>(State<double, 3>&);
template void move_lattices<float, 2>(State<float, 2>&);
template void move_lattices<float, 3>(State<float, 3>&);

}  // namespace pliant::remeshed

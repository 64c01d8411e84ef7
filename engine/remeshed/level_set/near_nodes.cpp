#include <cmath>

#include "engine/lattice/point_algebra.hpp"
#include "engine/remeshed/level_set/level_set.hpp"
#include "engine/remeshed/level_set/nearest_crossing.hpp"

// Closest points of the nodes near the surface, (RP.41).
namespace pliant::remeshed {

namespace {

constexpr double search_limit = 2.5;  // cells from a near node to its closest point

}  // namespace

template <class T, int D>
void LevelSet<T, D>::find_closest_points(const Block<D>& block,
                                         const kernels::RemeshedTable<T, D>& kernels) {
  thread_local Projections<T, D> near;
  near.clear(block.lower);
  layout_->for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
    phi_[p] = extended_[p];
    if (std::abs(extended_[p]) > near_band * lattice_->spacing || !lattice_->is_wrapped(cell)) {
      return;
    }
    near.add(p, cell, as_point<D>(cell));
  });
  constexpr int farthest_move = 3, iterations = 12;
  near.run(*lattice_, *layout_, extended_, farthest_move, iterations, kernels);
  near.restart([&](std::size_t i, Point<D>& start) {
    const bool again = passes_surface(near, i, start);
    if (!again) place_near(near, i);
    return again;
  });
  near.run(*lattice_, *layout_, extended_, farthest_move, iterations, kernels);
  for (std::size_t i = 0; i < near.size(); ++i) place_near(near, i);
}

// Whether the surface has a nearer place, on a lattice line. From a node on the bisector of an
// edge, the iteration may end on the edge, where the distance is stationary but not least.
template <class T, int D>
bool LevelSet<T, D>::passes_surface(const Projections<T, D>& near, std::size_t i,
                                    Point<D>& nearer) const {
  constexpr double least_gain = 0.1;  // cells
  if (!near.has_converged(i)) return false;
  const Point<D> node = near.node(i);
  const double distance = norm<D>(difference<D>(near.point(i), node));
  const double expected = std::abs(extended_[near.slot(i)]) / lattice_->spacing;
  Point<D> offset;
  if (distance < expected + least_gain ||
      !nearest_crossing<T, D>(*lattice_, *layout_, extended_, near.cell(i), offset) ||
      norm<D>(offset) > distance - least_gain) {
    return false;
  }
  for (int a = 0; a < D; ++a) nearer[a] = node[a] + offset[a];
  return true;
}

// Whether a step from a node along grad phi, (RP.41), reaches the surface. Where a contact wall has
// squeezed a body, abs(grad phi) may be 2, and the step ends far from the surface.
template <class T, int D>
bool LevelSet<T, D>::step_to_surface(const Cell<D>& cell, std::int64_t slot,
                                     Point<D>& offset) const {
  constexpr double tolerance = 0.25;  // [h]
  const double h = lattice_->spacing;
  Point<D> g, x = lattice_->node(cell);
  if (!gradient(cell, g)) return false;
  const double square = dot<D>(g, g);
  for (int a = 0; a < D; ++a) {
    offset[a] = -extended_[slot] / h * g[a] / square;
    x[a] += h * offset[a];
  }
  double phi = 0;
  return interpolate(extended_, x, phi) && std::abs(phi) < tolerance * h;
}

template <class T, int D>
void LevelSet<T, D>::place_near(const Projections<T, D>& near, std::size_t i) {
  const std::int64_t slot = near.slot(i);
  const Point<D> offset = difference<D>(near.point(i), near.node(i));
  const double distance = std::sqrt(dot<D>(offset, offset));
  if (near.has_converged(i) && distance <= search_limit) {
    for (int a = 0; a < D; ++a) foot_[a][slot] = offset[a];
    layer_[0][slot] = found;
    return;
  }
  Point<D> guess;
  if (!step_to_surface(near.cell(i), slot, guess) &&
      !nearest_crossing<T, D>(*lattice_, *layout_, extended_, near.cell(i), guess))
    return;
  for (int a = 0; a < D; ++a) foot_[a][slot] = guess[a];
  layer_[0][slot] = guessed;
}

template void LevelSet<double, 2>::find_closest_points(const Block<2>&,
                                                       const kernels::RemeshedTable<double, 2>&);
template bool LevelSet<double, 2>::passes_surface(const Projections<double, 2>&, std::size_t,
                                                  Point<2>&) const;
template bool LevelSet<double, 2>::step_to_surface(const Cell<2>&, std::int64_t, Point<2>&) const;
template void LevelSet<double, 2>::place_near(const Projections<double, 2>&, std::size_t);
template void LevelSet<double, 3>::find_closest_points(const Block<3>&,
                                                       const kernels::RemeshedTable<double, 3>&);
template bool LevelSet<double, 3>::passes_surface(const Projections<double, 3>&, std::size_t,
                                                  Point<3>&) const;
template bool LevelSet<double, 3>::step_to_surface(const Cell<3>&, std::int64_t, Point<3>&) const;
template void LevelSet<double, 3>::place_near(const Projections<double, 3>&, std::size_t);
template void LevelSet<float, 2>::find_closest_points(const Block<2>&,
                                                      const kernels::RemeshedTable<float, 2>&);
template bool LevelSet<float, 2>::passes_surface(const Projections<float, 2>&, std::size_t,
                                                 Point<2>&) const;
template bool LevelSet<float, 2>::step_to_surface(const Cell<2>&, std::int64_t, Point<2>&) const;
template void LevelSet<float, 2>::place_near(const Projections<float, 2>&, std::size_t);
template void LevelSet<float, 3>::find_closest_points(const Block<3>&,
                                                      const kernels::RemeshedTable<float, 3>&);
template bool LevelSet<float, 3>::passes_surface(const Projections<float, 3>&, std::size_t,
                                                 Point<3>&) const;
template bool LevelSet<float, 3>::step_to_surface(const Cell<3>&, std::int64_t, Point<3>&) const;
template void LevelSet<float, 3>::place_near(const Projections<float, 3>&, std::size_t);

}  // namespace pliant::remeshed

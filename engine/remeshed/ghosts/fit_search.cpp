#include "engine/remeshed/ghosts/fit_search.hpp"

#include <cmath>

namespace pliant::remeshed {

template <class T, int D>
void FitSearch<T, D>::find(const Point<D>& centre, const FitReach<D>& reach, const Wall<D>* wall,
                           FitParticles<D>& particles) const {
  particles.clear();
  const double radius = reach.radius, steepness = reach.steepness();
  const Position<D> broad = reach.broad();
  const double inverse_spacing = 1 / lattice_.spacing;
  const bool is_periodic = lattice_.is_periodic();
  Cell<D> first_row = {}, last_row = {};
  for (int a = 1; a < D; ++a) {
    first_row[a] = cell_above(centre[a] - radius);
    last_row[a] = cell_below(centre[a] + radius);
  }
  Position<D> r;
  for_each_cell<D>(first_row, last_row, [&](Cell<D> cell) {
    double square = radius * radius;
    for (int a = 1; a < D; ++a) {
      r[a] = cell[a] - centre[a];
      square -= r[a] * r[a];
    }
    if (square <= 0) return;
    const double chord = std::sqrt(square);
    cell[0] = cell_above(centre[0] - chord);
    const std::int32_t last = cell_below(centre[0] + chord);
    // One look-up suffices for a row within one run.
    std::int64_t slot = is_periodic ? -1 : population_.layout.slot(cell, last + 1 - cell[0]);
    const bool in_one_run = slot >= 0;
    for (; cell[0] <= last; ++cell[0], ++slot) {
      if (!in_one_run) slot = population_.layout.slot(lattice_.wrapped(cell));
      if (slot < 0 || population_.kind[slot] != Kind::interior) continue;
      r[0] = cell[0] - centre[0];
      const double along = broad.dot(r);
      const double root = 1 - steepness * r.squaredNorm() + along * along;
      if (root <= 0) continue;
      const double distance =
          wall ? wall->distance(lattice_.node(cell)) : level_set_.surface_distance(slot);
      particles.push_back(
          {static_cast<std::int32_t>(slot), root * root, distance * inverse_spacing, r});
    }
  });
}

template class FitSearch<double, 2>;
template class FitSearch<double, 3>;
template class FitSearch<float, 2>;
template class FitSearch<float, 3>;

}  // namespace pliant::remeshed

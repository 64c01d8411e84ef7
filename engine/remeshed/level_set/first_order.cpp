#include "engine/remeshed/level_set/first_order.hpp"

#include <algorithm>
#include <cmath>

namespace pliant::remeshed {

namespace {

/// Godunov's abs(grad phi): for each axis the steeper difference to the neighbours that are nearer
/// to the surface [1]. Neighbours without a slot do not count.
template <class T, int D>
double upwind_slope(const Lattice<D>& lattice, const Layout<D>& layout, const T* phi,
                    std::int64_t slot, const Cell<D>& cell) {
  const double own = phi[slot], sign = own < 0 ? -1 : 1;
  double square = 0;
  for (int a = 0; a < D; ++a) {
    double steepest = 0;
    for (const int to : {-1, 1}) {
      Cell<D> other = cell;
      other[a] += to;
      const std::int64_t q = layout.slot(lattice.wrapped(other));
      if (q >= 0) steepest = std::max(steepest, sign * (own - phi[q]) / lattice.spacing);
    }
    square += steepest * steepest;
  }
  return std::sqrt(square);
}

}  // namespace

template <class T, int D>
void advance_to_distance(const Lattice<D>& lattice, const Layout<D>& layout, const Block<D>& block,
                         const T* start, const T* from, T* to) {
  const double h = lattice.spacing;
  layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
    to[p] = from[p];
    if (!lattice.is_wrapped(cell)) return;
    const double phi0 = start[p], s = phi0 / std::sqrt(phi0 * phi0 + h * h);
    const double slope = upwind_slope<T, D>(lattice, layout, from, p, cell);
    to[p] = static_cast<T>(from[p] - h / 2 * s * (slope - 1));
  });
}

template void advance_to_distance<double, 2>(const Lattice<2>&, const Layout<2>&, const Block<2>&,
                                             const double*, const double*, double*);
template void advance_to_distance<double, 3>(const Lattice<3>&, const Layout<3>&, const Block<3>&,
                                             const double*, const double*, double*);
template void advance_to_distance<float, 2>(const Lattice<2>&, const Layout<2>&, const Block<2>&,
                                            const float*, const float*, float*);
template void advance_to_distance<float, 3>(const Lattice<3>&, const Layout<3>&, const Block<3>&,
                                            const float*, const float*, float*);

}  // namespace pliant::remeshed

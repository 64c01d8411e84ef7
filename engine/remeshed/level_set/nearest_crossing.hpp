#pragma once

#include <cstdint>
#include <limits>

#include "engine/lattice/layout.hpp"
#include "engine/lattice/point_algebra.hpp"

namespace pliant::remeshed {

/// The nearest place to a node where phi changes its sign between two neighbours on a lattice line,
/// minus the node, in cells, (RP.41). False if there is none within three cells along each axis:
/// the node is then far from the surface, whatever phi says.
template <class T, int D>
bool nearest_crossing(const Lattice<D>& lattice, const Layout<D>& layout, const T* phi,
                      const Cell<D>& node, Point<D>& offset) {
  constexpr int reach = 3;
  Cell<D> lower = node, upper = node;
  for (int a = 0; a < D; ++a) {
    lower[a] -= reach;
    upper[a] += reach;
  }
  double nearest = std::numeric_limits<double>::infinity();
  for_each_cell<D>(lower, upper, [&](const Cell<D>& from) {
    const std::int64_t p = layout.slot(lattice.wrapped(from));
    if (p < 0) return;
    for (int a = 0; a < D; ++a) {
      Cell<D> to = from;
      ++to[a];
      const std::int64_t q = layout.slot(lattice.wrapped(to));
      if (q < 0 || (phi[q] < 0) == (phi[p] < 0)) continue;
      Point<D> crossing;
      for (int b = 0; b < D; ++b) crossing[b] = from[b] - node[b];
      crossing[a] += phi[p] / (phi[p] - phi[q]);
      const double square = dot<D>(crossing, crossing);
      if (square >= nearest) continue;
      nearest = square;
      offset = crossing;
    }
  });
  return nearest < std::numeric_limits<double>::infinity();
}

}  // namespace pliant::remeshed

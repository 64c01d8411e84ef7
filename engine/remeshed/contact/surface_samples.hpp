#pragma once

#include <cmath>
#include <vector>

#include "engine/blocks/cell_list.hpp"
#include "engine/lattice/lattice.hpp"

namespace pliant::remeshed {

/// A coordinate over h; in periodic directions, moved into the first period.
template <int D>
double in_first_period(double x, const Lattice<D>& lattice, int axis) {
  const std::int32_t n = lattice.period[axis];
  return n == 0 ? x : x - n * std::floor(x / n);
}

/// A position over h; that of a node is its cell.
template <int D>
Point<D> place(const Point<D>& x, const Lattice<D>& lattice) {
  Point<D> at;
  for (int a = 0; a < D; ++a) {
    at[a] = in_first_period<D>((x[a] - lattice.origin[a]) / lattice.spacing - 0.5, lattice, a);
  }
  return at;
}

/// The surface particles and ghosts of a body at the start of a step.
template <int D>
struct SurfaceSamples {
  Point<D> lower, upper;               ///< of the places of sites
  std::vector<std::int32_t> record;    ///< [sample] of a particle; -1: a ghost
  std::vector<double> level_set;       ///< [sample] [h]
  std::vector<Point<D>> gradient;      ///< [sample] of phi, of a particle
  std::vector<Point<D>> displacement;  ///< [sample] since t = 0 [m]
  CellList<double, D> cells;           ///< the label of a site is the number of its sample
  bool is_near_another = false;        ///< another body that it may touch

  /// Whether a place is in the box or within `margin` of it [h].
  bool holds(const Point<D>& at, const Lattice<D>& lattice, double margin) const {
    for (int a = 0; a < D; ++a) {
      if (lattice.period[a] != 0) continue;
      if (at[a] < lower[a] - margin || at[a] > upper[a] + margin) return false;
    }
    return true;
  }
};

}  // namespace pliant::remeshed

#pragma once

#include "engine/lattice/lattice.hpp"

namespace pliant {

/// Calls f(cell, weight) for the 2^D nodes around x with the weights of multilinear interpolation,
/// until a call returns false. Returns whether none did.
template <int D, class F>
bool for_each_corner(const Lattice<D>& lattice, const Point<D>& x, F&& f) {
  Cell<D> base;
  Point<D> s;
  for (int a = 0; a < D; ++a) {
    const double at = (x[a] - lattice.origin[a]) / lattice.spacing - 0.5;
    base[a] = cell_below(at);
    s[a] = at - base[a];
  }
  for (int corner = 0; corner < (1 << D); ++corner) {
    Cell<D> cell = base;
    double weight = 1;
    for (int a = 0; a < D; ++a) {
      const int up = corner >> a & 1;
      cell[a] += up;
      weight *= up ? s[a] : 1 - s[a];
    }
    if (!f(cell, weight)) return false;
  }
  return true;
}

}  // namespace pliant

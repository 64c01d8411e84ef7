#pragma once

#include <cmath>

#include "engine/case/expression.hpp"
#include "engine/lattice/point_algebra.hpp"

namespace pliant {

/// The share of a cell that lies in the region where `where` is not zero at time t. `place(r)` is
/// the present place of the point of the cell at r, which runs from 0 to 1 along each axis. Cells
/// whose corners and middle agree are in the region as a whole, or not at all; others count by
/// samples.
template <int D, class Place>
double share_in_region(const Expression& where, double t, const Place& place) {
  constexpr int samples = D == 2 ? 16 : 6;  // along each axis
  const auto is_inside = [&](const Point<D>& r) {
    const Point<D> x = place(r);
    if constexpr (D == 2) return where(x[0], x[1], 0, t) != 0;
    if constexpr (D == 3) return where(x[0], x[1], x[2], t) != 0;
  };
  Point<D> middle;
  middle.fill(0.5);
  const bool is_middle_inside = is_inside(middle);
  bool agree = true;
  Cell<D> last;
  last.fill(1);
  for_each_cell<D>({}, last, [&](const Cell<D>& corner) {
    agree = agree && is_inside(as_point<D>(corner)) == is_middle_inside;
  });
  if (agree) return is_middle_inside ? 1 : 0;
  double inside = 0;
  last.fill(samples - 1);
  for_each_cell<D>({}, last, [&](const Cell<D>& number) {
    Point<D> sample = as_point<D>(number);
    for (double& r : sample) r = (r + 0.5) / samples;
    inside += is_inside(sample) ? 1 : 0;
  });
  return inside / std::pow(samples, D);
}

}  // namespace pliant

#pragma once

#include <algorithm>
#include <vector>

#include "tests/engine/lattice/random_cells.hpp"

namespace pliant::test {

/// A cell as a point, in cells.
template <int D>
Point<D> point_of(const Cell<D>& cell) {
  Point<D> x;
  std::copy(cell.begin(), cell.end(), x.begin());
  return x;
}

/// Values f(x) on the nodes of a full block of cells 0..upper, with x in cells.
template <int D>
struct NodeValues {
  template <class F>
  NodeValues(const Cell<D>& upper, const Cell<D>& period, F&& f, double spacing = 1) {
    lattice.spacing = spacing;
    lattice.period = period;
    layout.build(random_occupancy<D>({}, upper, 1, 1), period, 1000, 10);
    values.resize(layout.slots());
    for_each_cell<D>(
        {}, upper, [&](const Cell<D>& cell) { values[layout.slot(cell)] = f(point_of<D>(cell)); });
  }

  Lattice<D> lattice;
  Layout<D> layout;
  std::vector<double> values;
};

}  // namespace pliant::test

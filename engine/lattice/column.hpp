#pragma once

#include <Eigen/Core>

#include "engine/lattice/lattice.hpp"

namespace pliant {

template <int D>
using Column = Eigen::Matrix<double, D, 1>;

/// A point as a column of a matrix.
template <int D>
Column<D> column(const Point<D>& x) {
  return Eigen::Map<const Column<D>>(x.data());
}

/// The reverse.
template <int D>
Point<D> as_point(const Column<D>& x) {
  Point<D> point;
  Eigen::Map<Column<D>>(point.data()) = x;
  return point;
}

}  // namespace pliant

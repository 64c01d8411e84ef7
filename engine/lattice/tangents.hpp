#pragma once

#include <Eigen/Geometry>

#include "engine/lattice/column.hpp"

namespace pliant {

/// Unit vectors along a plane, in columns; `normal` has any length.
template <int D>
Eigen::Matrix<double, D, D - 1> tangents(const Column<D>& normal) {
  Eigen::Matrix<double, D, D - 1> along;
  const Column<D> n = normal.normalized();
  if constexpr (D == 2) {
    along << -n[1], n[0];
  } else {
    along.col(0) = n.unitOrthogonal();
    along.col(1) = n.cross(along.col(0));
  }
  return along;
}

}  // namespace pliant

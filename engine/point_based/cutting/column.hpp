#pragma once

#include <Eigen/Core>

#include "engine/point_based/cutting/cut_surface.hpp"

namespace pliant::point_based {

template <int D>
using Column = Eigen::Matrix<double, D, 1>;

template <int D>
Column<D> column(const MaterialPoint<D>& x) {
  return Eigen::Map<const Column<D>>(x.data());
}

}  // namespace pliant::point_based

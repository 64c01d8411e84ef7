#pragma once

#include <Eigen/Dense>
#include <cmath>

#include "engine/point_based/body.hpp"

namespace pliant::test {

/// x = F X + a wave, so that all parts of the energy contribute.
template <int D>
void deform(point_based::Body<double, D>& body, const Eigen::Matrix<double, D, D>& f, double wave) {
  body.for_each_node([&](std::int64_t slot) {
    for (int i = 0; i < D; ++i) {
      double d = -body.start[slot][i] + wave * std::sin(37. * slot + 5 * i);
      for (int j = 0; j < D; ++j) d += f(i, j) * body.start[slot][j];
      body.displacement[i][slot] = d;
    }
  });
}

template <int D>
Eigen::Matrix<double, D, D> some_deformation() {
  Eigen::Matrix3d f;
  f << 1.2, 0.3, -0.1, -0.2, 0.9, 0.15, 0.05, -0.25, 1.1;
  return f.topLeftCorner<D, D>();
}

}  // namespace pliant::test

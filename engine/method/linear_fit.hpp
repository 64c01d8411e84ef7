#pragma once

#include <Eigen/Cholesky>
#include <array>

#include "engine/lattice/lattice.hpp"

namespace pliant {

/// Weighted least squares of `V` fields by linear functions of the distance from a point.
template <int D, int V>
class LinearFit {
 public:
  /// `r`: from the point to where the values are, in any unit.
  void add(const Point<D>& r, double weight, const std::array<double, V>& values) {
    Eigen::Matrix<double, D + 1, 1> q;
    q[0] = 1;
    for (int a = 0; a < D; ++a) q[a + 1] = r[a];
    normal_ += weight * q * q.transpose();
    for (int v = 0; v < V; ++v) right_.col(v) += weight * values[v] * q;
  }

  /// False where the values determine no linear functions.
  bool solve() {
    const auto factors = normal_.ldlt();
    const auto pivots = factors.vectorD();
    constexpr double singular = 1e-9;
    if (!(pivots.minCoeff() > singular * pivots.maxCoeff())) return false;
    right_ = factors.solve(right_).eval();
    return true;
  }

  /// At the point, after `solve`.
  double value(int field) const { return right_(0, field); }
  /// Along an axis [1/unit of r], after `solve`.
  double slope(int field, int axis) const { return right_(axis + 1, field); }

 private:
  Eigen::Matrix<double, D + 1, D + 1> normal_ = Eigen::Matrix<double, D + 1, D + 1>::Zero();
  Eigen::Matrix<double, D + 1, V> right_ = Eigen::Matrix<double, D + 1, V>::Zero();
};

}  // namespace pliant

#pragma once

#include <cmath>

#include "kernels/remeshed/table.hpp"
#include "tests/kernels/field.hpp"

namespace pliant::kernels::test {

/// The signed distance from a ball on a box of nodes, and the nodes within 1.8 cells of its
/// surface.
template <class T, int D>
struct NodesOfABall {
  explicit NodesOfABall(double radius_in_cells)
      : radius(radius_in_cells), width(2 * static_cast<int>(std::ceil(radius + 4))) {
    int total = 1;
    for (int a = 0; a < D; ++a) total *= width;
    for (int n = 0; n < total; ++n) add(n);
    count = static_cast<int>(node[0].size());
    while (node[0].size() % slots_per_pack != 0) {
      for (int a = 0; a < D; ++a) node[a].push_back(node[a].back());
    }
    point = node;
    converged.resize(node[0].size());
  }

  double centre(int axis) const { return lower + width / 2 + 0.21 * axis; }

  double distance_from_centre(const std::array<Field<T>, D>& x, int i) const {
    double square = 0;
    for (int a = 0; a < D; ++a) square += std::pow(x[a][i] - centre(a), 2);
    return std::sqrt(square);
  }

  ClosestPoints<T, D> arguments() {
    ClosestPoints<T, D> work = {};
    work.values = values.data();
    work.lower.fill(lower);
    work.extent.fill(width);
    work.count = count;
    work.iterations = 12;
    work.flattest = T(0.05);
    work.shortest_step = T(1e-4);
    work.smallest_value = T(1e-3);
    for (int a = 0; a < D; ++a) {
      work.node[a] = node[a].data();
      work.point[a] = point[a].data();
    }
    work.converged = converged.data();
    return work;
  }

  double radius;
  int width, count;
  Field<T> values, converged;
  std::array<Field<T>, D> node, point;

 private:
  static constexpr int lower = -9;

  void add(int n) {
    double x[D], square = 0;
    for (int a = 0; a < D; ++a, n /= width) {
      x[a] = lower + n % width;
      square += std::pow(x[a] - centre(a), 2);
    }
    const double phi = std::sqrt(square) - radius;
    values.push_back(static_cast<T>(phi));
    if (std::abs(phi) > 1.8) return;
    for (int a = 0; a < D; ++a) node[a].push_back(static_cast<T>(x[a]));
  }
};

}  // namespace pliant::kernels::test

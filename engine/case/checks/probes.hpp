#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "engine/geometry/signed_distance.hpp"

/// Points at which checks look at a body.
namespace pliant {

/// The centres of the cells of a lattice in a box.
inline std::vector<Vector> middles(const Box<3>& box, int dimension, double step) {
  std::array<int, 3> count = {1, 1, 1};
  for (int a = 0; a < dimension; ++a) {
    count[a] = static_cast<int>(std::ceil((box.upper[a] - box.lower[a]) / step));
  }
  std::vector<Vector> found;
  for (int k = 0; k < count[0] * count[1] * count[2]; ++k) {
    const std::array<int, 3> cell = {k % count[0], k / count[0] % count[1],
                                     k / count[0] / count[1]};
    Vector& x = found.emplace_back();
    for (int a = 0; a < dimension; ++a) {
      x[a] = box.lower[a] + (cell[a] + 0.5) * (box.upper[a] - box.lower[a]) / count[a];
    }
  }
  return found;
}

/// The distance between neighbours of some 4000 points in a box.
inline double step_of_probes(const Box<3>& box, int dimension) {
  constexpr double probes = 4000;
  double volume = 1;
  for (int a = 0; a < dimension; ++a) volume *= box.upper[a] - box.lower[a];
  return std::pow(volume / probes, 1. / dimension);
}

/// The point of the surface next to `x`.
inline Vector foot_of(const Shape& shape, Vector x, int dimension) {
  constexpr int steps = 3;
  for (int k = 0; k < steps; ++k) {
    const double distance = signed_distance(shape, x, dimension);
    const Vector out = outward_direction(shape, x, dimension);
    for (int a = 0; a < dimension; ++a) x[a] -= distance * out[a];
  }
  return x;
}

}  // namespace pliant

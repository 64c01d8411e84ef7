#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/lattice/lattice.hpp"

namespace pliant {

/// Distances on a lattice that are to be interpolated linearly between its points, (TL.33). `phi`
/// are distances in spacings, `extent` points along each axis, the first axis fastest.
///
/// A distance is convex around a convex body: linear interpolation exceeds it, on average by
/// delta^2 phi/12 for each axis, delta^2 the second difference. The body would have too little
/// volume. Points beside edges, where phi is not smooth, keep their distance.
template <int D>
std::vector<double> mean_phi(const std::vector<double>& phi, const Cell<D>& extent) {
  constexpr double near = 1;       // farther away, distances may be bounds
  constexpr double smooth = 0.35;  // second difference on a sphere of three spacings
  std::vector<double> mean = phi;
  Cell<D> first, last;
  for (int a = 0; a < D; ++a) {
    first[a] = 1;
    last[a] = extent[a] - 2;
  }
  for_each_cell<D>(first, last, [&](const Cell<D>& point) {
    std::int64_t at = 0;
    for (int a = D - 1; a >= 0; --a) at = at * extent[a] + point[a];
    if (std::abs(phi[at]) > near) return;
    double sum = 0, largest = 0;
    std::int64_t stride = 1;
    for (int a = 0; a < D; ++a) {
      const double second = phi[at - stride] - 2 * phi[at] + phi[at + stride];
      sum += second;
      largest = std::max(largest, std::abs(second));
      stride *= extent[a];
    }
    constexpr double rounding = 1e-9;  // of planes
    if (largest > rounding && largest < smooth) mean[at] -= sum / 12;
  });
  return mean;
}

}  // namespace pliant

#pragma once

#include <array>

/// Means over the part of a cell that lies in the body, (TL.36). Coordinates in a cell are -1 on
/// its lower and 1 on its upper face. Modes of corner values are those of (TL.2).
namespace pliant::total_lagrangian {

/// [mode] Means m_b of the product of the coordinates in the directions of a mode.
template <int D>
using CellMoments = std::array<double, (1 << D)>;

template <int D>
inline constexpr CellMoments<D> moments_of_whole_cell = {1};

/// s_b(c) of (TL.2).
constexpr int sign_of_mode(int mode, int corner) {
  int sign = 1;
  for (int lower = mode & ~corner; lower != 0; lower &= lower - 1) sign = -sign;
  return sign;
}

/// Mean over the part of the multilinear function that is 1 at corner `c` and 0 at the others.
template <int D>
double mean_weight(const CellMoments<D>& moment, int c) {
  double sum = 0;
  for (int m = 0; m < (1 << D); ++m) sum += sign_of_mode(m, c) * moment[m];
  return sum / (1 << D);
}

/// Mean over the part of the derivative of that function along an axis, in units of 2/(2^D h).
template <int D>
double mean_slope(const CellMoments<D>& moment, int c, int axis) {
  double sum = 0;
  for (int m = 0; m < (1 << D); ++m) {
    if (!(m >> axis & 1)) sum += sign_of_mode(m | 1 << axis, c) * moment[m];
  }
  return sum;
}

}  // namespace pliant::total_lagrangian

#pragma once

#include "kernels/pack.hpp"
#include "kernels/total_lagrangian/arguments.hpp"

/// Modes of the corner values of a cell, (TL.2), by in-place fast Walsh transforms.
namespace pliant::kernels {

/// From corner values to modes. Mode 0 becomes the sum of the values.
template <class P, int D>
inline void to_modes(P (&value)[1 << D]) {
#pragma GCC unroll 3
  for (int bit = 1; bit < (1 << D); bit <<= 1) {
#pragma GCC unroll 8
    for (int c = 0; c < (1 << D); ++c) {
      if (c & bit) continue;
      const P lower = value[c], upper = value[c | bit];
      value[c] = upper + lower;
      value[c | bit] = upper - lower;
    }
  }
}

/// The transpose: from the forces of modes to the forces at corners. Mode 0 has no force.
template <class P, int D>
inline void to_corners(P (&value)[1 << D]) {
  value[0] = -value[1];
#pragma GCC unroll 3
  for (int c = 2; c < (1 << D); c += 2) {
    const P even = value[c], odd = value[c | 1];
    value[c] = even - odd;
    value[c | 1] = even + odd;
  }
#pragma GCC unroll 3
  for (int bit = 2; bit < (1 << D); bit <<= 1) {
#pragma GCC unroll 8
    for (int c = 0; c < (1 << D); ++c) {
      if (c & bit) continue;
      const P without = value[c], with = value[c | bit];
      value[c] = without - with;
      value[c | bit] = without + with;
    }
  }
}

/// Adds to each gradient mode what makes it the mean over the part of the cell in the body, in
/// place of the value in the middle, (TL.36). `moment(b)` is m_b.
template <class P, int D, class Moment>
inline void to_means(Moment&& moment, P (&mode)[1 << D]) {
#pragma GCC unroll 8
  for (int m = 1; m < (1 << D); ++m) {
    if (directions_of[m] < 2) continue;
#pragma GCC unroll 3
    for (int a = 0; a < D; ++a) {
      if (m >> a & 1) mode[1 << a] = fused(moment(m ^ 1 << a), mode[m], mode[1 << a]);
    }
  }
}

/// The transpose: adds the forces of these means to those of the hourglass modes.
template <class P, int D, class Moment>
inline void from_means(Moment&& moment, P (&force)[1 << D]) {
#pragma GCC unroll 8
  for (int m = 1; m < (1 << D); ++m) {
    if (directions_of[m] < 2) continue;
#pragma GCC unroll 3
    for (int a = 0; a < D; ++a) {
      if (m >> a & 1) force[m] = fused(moment(m ^ 1 << a), force[1 << a], force[m]);
    }
  }
}

}  // namespace pliant::kernels

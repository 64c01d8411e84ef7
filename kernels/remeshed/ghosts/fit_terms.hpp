#pragma once

#include <array>
#include <cstdint>

/// The fits of a ghost: moving least squares, whose coefficients are a weight times a polynomial.
/// Storing its terms takes less memory than coefficients: a few for each ghost instead of three for
/// each of its particles. Coefficients are computed from the terms when needed.
namespace pliant::kernels {

/// Coefficients of the particle at r from the ghost's foot point and phi from the surface or the
/// wall, all over h:
///
///     c = w (c_0 + sum_a c_a r_a)                        (RP.43) at the ghost
///     a = w (a_0 + sum_a a_a r_a)                        (RP.43) at the foot point
///     b = w phi (b_0 + sum_a b_a r_a + b_last phi)       (RP.44)
///     w = (1 - steepness r^2 + (broad.r)^2)^2, 0 where the bracket is below 0
template <class T, int D>
struct FitTerms {
  std::array<T, D> start = {};  ///< from the foot point to the cell at which offsets start
  T steepness = 0;
  std::array<T, D> broad = {};
  std::array<T, D + 1> linear = {}, surface = {};
  std::array<T, D + 2> constrained = {};
};

/// A particle of a ghost's fits. The lower half is its record; the upper half has a byte for each
/// axis, the offset to it in cells, -128 to 127, plus 128.
using FitPair = std::int64_t;

template <int D>
constexpr FitPair fit_pair(std::int32_t record, const std::array<std::int32_t, D>& cells) {
  FitPair pair = record;
  for (int a = 0; a < D; ++a) pair |= static_cast<FitPair>(cells[a] + 128) << (32 + 8 * a);
  return pair;
}

constexpr std::int32_t record_of(FitPair pair) { return static_cast<std::int32_t>(pair); }

constexpr FitPair with_record(FitPair pair, std::int32_t record) {
  return (pair >> 32 << 32) | record;
}

constexpr double cells_along(FitPair pair, int axis) {
  return static_cast<double>((pair >> (32 + 8 * axis) & 255) - 128);
}

}  // namespace pliant::kernels

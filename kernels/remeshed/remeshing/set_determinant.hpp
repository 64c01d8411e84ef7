#pragma once

#include <array>
#include <cmath>
#include <limits>

/// Small row-major matrices in plain scalars.
namespace pliant::kernels {

template <class T>
std::array<T, 4> cofactors(const std::array<T, 4>& f) {
  return {f[3], -f[2], -f[1], f[0]};
}

template <class T>
std::array<T, 9> cofactors(const std::array<T, 9>& f) {
  return {f[4] * f[8] - f[5] * f[7], f[5] * f[6] - f[3] * f[8], f[3] * f[7] - f[4] * f[6],
          f[2] * f[7] - f[1] * f[8], f[0] * f[8] - f[2] * f[6], f[1] * f[6] - f[0] * f[7],
          f[1] * f[5] - f[2] * f[4], f[2] * f[3] - f[0] * f[5], f[0] * f[4] - f[1] * f[3]};
}

template <class T, int D>
T determinant(const std::array<T, D * D>& f) {
  const auto cofactor = cofactors(f);
  T sum = 0;
  for (int c = 0; c < D; ++c) sum += f[c] * cofactor[c];
  return sum;
}

/// Changes `f` as little as possible so that its determinant is `value` > 0, (RP.38). Newton's
/// method moves along the cofactors, the direction of fastest growth of the determinant. The
/// correction falls on the smallest stretches and hardly changes large ones.
template <class T, int D>
void set_determinant(std::array<T, D * D>& f, T value) {
  constexpr int most_iterations = 8;
  constexpr T tolerance = 16 * std::numeric_limits<T>::epsilon();
  for (int i = 0; i < most_iterations; ++i) {
    const auto cofactor = cofactors(f);
    T square = 0;
    for (const T c : cofactor) square += c * c;
    const T missing = value - determinant<T, D>(f);
    if (std::abs(missing) <= tolerance * value) return;
    for (int c = 0; c < D * D; ++c) f[c] += missing / square * cofactor[c];
  }
}

}  // namespace pliant::kernels

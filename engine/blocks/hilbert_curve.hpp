#pragma once

#include <array>
#include <cstdint>

namespace pliant {

/// Resolution of hilbert_key: 2^bits places along each axis.
template <int D>
inline constexpr int hilbert_bits = 63 / D;

/// Position of a grid point on the Hilbert curve through a grid of 2^bits points along each axis.
/// Consecutive points of the curve are adjacent. Coordinates must be below 2^bits.
///
/// Source: J. Skilling, Programming the Hilbert curve, AIP Conf. Proc. 707 (2004) 381.
template <int D>
constexpr std::uint64_t hilbert_key(std::array<std::uint32_t, D> x, int bits = hilbert_bits<D>) {
  const std::uint32_t highest = std::uint32_t{1} << (bits - 1);
  for (std::uint32_t bit = highest; bit > 1; bit >>= 1) {
    const std::uint32_t below = bit - 1;
    for (int a = 0; a < D; ++a) {
      if ((x[a] & bit) != 0) {
        x[0] ^= below;
      } else {
        const std::uint32_t exchanged = (x[0] ^ x[a]) & below;
        x[0] ^= exchanged;
        x[a] ^= exchanged;
      }
    }
  }
  for (int a = 1; a < D; ++a) x[a] ^= x[a - 1];
  std::uint32_t flips = 0;
  for (std::uint32_t bit = highest; bit > 1; bit >>= 1) {
    if ((x[D - 1] & bit) != 0) flips ^= bit - 1;
  }
  std::uint64_t key = 0;
  for (int bit = bits - 1; bit >= 0; --bit) {
    for (int a = 0; a < D; ++a) key = key << 1 | ((x[a] ^ flips) >> bit & 1u);
  }
  return key;
}

}  // namespace pliant

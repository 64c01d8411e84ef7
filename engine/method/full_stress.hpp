#pragma once

#include <array>

#include "kernels/layout.hpp"

namespace pliant {

/// The components xx, yy, zz, xy, yz, xz of a stress that is stored in the order of
/// symmetric_index. In plane strain sigma_zz = -3 p - sigma_xx - sigma_yy by (RP.11).
template <int D>
std::array<double, 6> full_stress(
    const std::array<double, kernels::symmetric_components<D>>& stress, double pressure) {
  const auto s = [&](int i, int j) { return stress[kernels::symmetric_index<D>(i, j)]; };
  if constexpr (D == 2) {
    return {s(0, 0), s(1, 1), -3 * pressure - s(0, 0) - s(1, 1), s(0, 1), 0, 0};
  } else {
    return {s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(1, 2), s(0, 2)};
  }
}

}  // namespace pliant

#pragma once

#include <cmath>

#include "engine/lattice/layout.hpp"

namespace pliant::remeshed {

/// Tensor-product cubic interpolation of a slot field, (RP.30). Positions are in cells: node c lies
/// at c; gradients are per cell.
template <class T, int D>
class CubicInterpolant {
 public:
  CubicInterpolant(const Lattice<D>& lattice, const Layout<D>& layout, const T* values)
      : lattice_(lattice), layout_(layout), values_(values) {}

  /// False where one of the 4^D nodes has no slot.
  bool operator()(const Point<D>& x, double& value, Point<D>& gradient) const {
    Cell<D> base;
    std::array<std::array<double, 4>, D> weight, slope;
    for (int a = 0; a < D; ++a) {
      const double floor = std::floor(x[a]);
      base[a] = static_cast<std::int32_t>(floor) - 1;
      lagrange(x[a] - floor, weight[a], slope[a]);
    }
    value = 0;
    gradient = {};
    for (int k = 0; k < (D == 3 ? 4 : 1); ++k) {
      for (int j = 0; j < 4; ++j) {
        std::array<double, 4> row;
        if (!load_row(base, j, k, row)) return false;
        double f = 0, df = 0;
        for (int i = 0; i < 4; ++i) {
          f += weight[0][i] * row[i];
          df += slope[0][i] * row[i];
        }
        const double outer = D == 3 ? weight[D - 1][k] : 1;
        value += outer * weight[1][j] * f;
        gradient[0] += outer * weight[1][j] * df;
        gradient[1] += outer * slope[1][j] * f;
        if constexpr (D == 3) gradient[2] += slope[2][k] * weight[1][j] * f;
      }
    }
    return true;
  }

 private:
  // The cubic through the nodes -1, 0, 1, 2 at 0 <= s < 1.
  static void lagrange(double s, std::array<double, 4>& w, std::array<double, 4>& dw) {
    w = {-s * (s - 1) * (s - 2) / 6, (s + 1) * (s - 1) * (s - 2) / 2, -(s + 1) * s * (s - 2) / 2,
         (s + 1) * s * (s - 1) / 6};
    dw = {-(3 * s * s - 6 * s + 2) / 6, (3 * s * s - 4 * s - 1) / 2, -(3 * s * s - 2 * s - 2) / 2,
          (3 * s * s - 1) / 6};
  }

  bool load_row(const Cell<D>& base, int j, int k, std::array<double, 4>& row) const {
    Cell<D> cell = base;
    cell[1] += j;
    if constexpr (D == 3) cell[2] += k;
    const Cell<D> first = lattice_.wrapped(cell);
    cell[0] += 3;
    const Cell<D> last = lattice_.wrapped(cell);
    const std::int64_t slot = layout_.slot(first), end = layout_.slot(last);
    if (slot < 0 || end < 0) return false;
    if (end - slot == 3) {
      for (int i = 0; i < 4; ++i) row[i] = values_[slot + i];
      return true;
    }
    for (int i = 0; i < 4; ++i) {  // across a period or a gap
      cell[0] = base[0] + i;
      const std::int64_t at = layout_.slot(lattice_.wrapped(cell));
      if (at < 0) return false;
      row[i] = values_[at];
    }
    return true;
  }

  const Lattice<D>& lattice_;
  const Layout<D>& layout_;
  const T* values_;
};

}  // namespace pliant::remeshed

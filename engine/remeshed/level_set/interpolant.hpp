#pragma once

#include <algorithm>

#include "engine/lattice/layout.hpp"
#include "kernels/remeshed/remeshing/cubic.hpp"

namespace pliant::remeshed {

/// Tensor-product cubic interpolation of a slot field, (RP.41). Positions are in cells: node c is
/// at c. Gradients are per cell.
template <class T, int D>
class CubicInterpolant {
 public:
  CubicInterpolant(const Lattice<D>& lattice, const Layout<D>& layout, const T* values)
      : lattice_(lattice), layout_(layout), values_(values) {}

  /// False if one of the 4^D nodes has no slot.
  bool operator()(const Point<D>& x, double& value, Point<D>& gradient) const {
    Cell<D> base;
    kernels::CubicWeights<double> weight[D];
    for (int a = 0; a < D; ++a) {
      const std::int32_t below = cell_below(x[a]);
      base[a] = below - 1;
      weight[a] = kernels::CubicWeights<double>(x[a] - below);
    }
    Nodes nodes;
    if (!load(base, nodes)) return false;
    double slope[D];
    kernels::interpolate(
        weight, [&](int n) { return nodes[n / 4][n % 4]; }, value, slope);
    std::copy_n(slope, D, gradient.begin());
    return true;
  }

 private:
  using Nodes = std::array<std::array<double, 4>, kernels::power(4, D - 1)>;

  bool load(const Cell<D>& base, Nodes& nodes) const {
    for (int k = 0; k < (D == 3 ? 4 : 1); ++k) {
      for (int j = 0; j < 4; ++j) {
        Cell<D> cell = base;
        cell[1] += j;
        if constexpr (D == 3) cell[2] += k;
        if (!load_row(cell, nodes[4 * k + j])) return false;
      }
    }
    return true;
  }

  bool load_row(Cell<D> cell, std::array<double, 4>& row) const {
    if (lattice_.period[0] == 0) {
      const std::int64_t slot = layout_.slot(lattice_.wrapped(cell), 4);
      if (slot >= 0) {
        for (int i = 0; i < 4; ++i) row[i] = values_[slot + i];
        return true;
      }
    }
    for (int i = 0; i < 4; ++i, ++cell[0]) {  // across a period or a gap
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

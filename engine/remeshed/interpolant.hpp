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

  /// The 4^D nodes around a cell, kept for the next point: iterations rarely leave their cell.
  struct Nodes {
    Cell<D> base;
    std::array<std::array<double, 4>, kernels::power(4, D - 1)> row;
    bool are_loaded = false;
  };

  /// False where one of the 4^D nodes has no slot.
  bool operator()(const Point<D>& x, double& value, Point<D>& gradient) const {
    Nodes nodes;
    return (*this)(x, nodes, value, gradient);
  }

  bool operator()(const Point<D>& x, Nodes& nodes, double& value, Point<D>& gradient) const {
    Cell<D> base;
    std::array<std::array<double, 4>, D> weight, slope;
    for (int a = 0; a < D; ++a) {
      const double floor = std::floor(x[a]);
      base[a] = static_cast<std::int32_t>(floor) - 1;
      lagrange(x[a] - floor, weight[a], slope[a]);
    }
    if (!nodes.are_loaded || nodes.base != base) {
      nodes.base = base;
      nodes.are_loaded = load(nodes);
      if (!nodes.are_loaded) return false;
    }
    if constexpr (D == 2) {
      contract(nodes.row.data(), weight, slope, value, gradient);
    } else {
      std::array<std::array<double, 4>, 4> plane = {}, along = {};
      for (int k = 0; k < 4; ++k) {
        for (int j = 0; j < 4; ++j) {
          for (int i = 0; i < 4; ++i) {
            plane[j][i] += weight[2][k] * nodes.row[4 * k + j][i];
            along[j][i] += slope[2][k] * nodes.row[4 * k + j][i];
          }
        }
      }
      contract(plane.data(), weight, slope, value, gradient);
      gradient[2] = 0;
      for (int i = 0; i < 4; ++i) {
        double f = 0;
        for (int j = 0; j < 4; ++j) f += weight[1][j] * along[j][i];
        gradient[2] += weight[0][i] * f;
      }
    }
    return true;
  }

 private:
  // Value and gradient in the plane of four rows.
  static void contract(const std::array<double, 4>* row,
                       const std::array<std::array<double, 4>, D>& weight,
                       const std::array<std::array<double, 4>, D>& slope, double& value,
                       Point<D>& gradient) {
    value = gradient[0] = gradient[1] = 0;
    for (int i = 0; i < 4; ++i) {
      double f = 0, df = 0;
      for (int j = 0; j < 4; ++j) {
        f += weight[1][j] * row[j][i];
        df += slope[1][j] * row[j][i];
      }
      value += weight[0][i] * f;
      gradient[0] += slope[0][i] * f;
      gradient[1] += weight[0][i] * df;
    }
  }

  // The cubic through the nodes -1, 0, 1, 2 at 0 <= s < 1.
  static void lagrange(double s, std::array<double, 4>& w, std::array<double, 4>& dw) {
    constexpr double sixth = 1.0 / 6;
    w = {-s * (s - 1) * (s - 2) * sixth, (s + 1) * (s - 1) * (s - 2) * 0.5,
         -(s + 1) * s * (s - 2) * 0.5, (s + 1) * s * (s - 1) * sixth};
    dw = {-(3 * s * s - 6 * s + 2) * sixth, (3 * s * s - 4 * s - 1) * 0.5,
          -(3 * s * s - 2 * s - 2) * 0.5, (3 * s * s - 1) * sixth};
  }

  bool load(Nodes& nodes) const {
    for (int k = 0; k < (D == 3 ? 4 : 1); ++k) {
      for (int j = 0; j < 4; ++j) {
        Cell<D> cell = nodes.base;
        cell[1] += j;
        if constexpr (D == 3) cell[2] += k;
        if (!load_row(cell, nodes.row[4 * k + j])) return false;
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

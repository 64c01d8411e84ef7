#pragma once

#include <array>
#include <cstdint>
#include <utility>

namespace pliant {

template <int D>
using Cell = std::array<std::int32_t, D>;
template <int D>
using Point = std::array<double, D>;

/// floor(x) and ceil(x). Without SSE4.1, those of the standard library are function calls.
inline std::int32_t cell_below(double x) {
  const auto whole = static_cast<std::int32_t>(x);
  return whole - (x < whole ? 1 : 0);
}
inline std::int32_t cell_above(double x) { return -cell_below(-x); }
inline std::int32_t nearest_cell(double x) { return cell_below(x + 0.5); }

/// Calls `f(cell)` for the cells first..last, inclusive, x fastest.
template <int D, int axis = D - 1, class F>
void for_each_cell(const Cell<D>& first, const Cell<D>& last, F&& f, Cell<D> cell = {}) {
  for (cell[axis] = first[axis]; cell[axis] <= last[axis]; ++cell[axis]) {
    if constexpr (axis == 0) {
      f(std::as_const(cell));
    } else {
      for_each_cell<D, axis - 1>(first, last, f, cell);
    }
  }
}

/// A square lattice with spacing h [m]: the node of cell c is at origin + (c + 1/2) h.
template <int D>
struct Lattice {
  double spacing = 0;
  Point<D> origin = {};
  Cell<D> period = {};  ///< in cells; 0: not periodic

  double node(int axis, std::int32_t cell) const { return origin[axis] + (cell + 0.5) * spacing; }

  Point<D> node(const Cell<D>& cell) const {
    Point<D> x;
    for (int a = 0; a < D; ++a) x[a] = node(a, cell[a]);
    return x;
  }

  /// The cell that contains coordinate `x`.
  std::int32_t cell(int axis, double x) const { return cell_below((x - origin[axis]) / spacing); }

  /// `cell` moved by whole periods into the first period.
  std::int32_t wrapped(int axis, std::int32_t cell) const {
    const std::int32_t n = period[axis];
    if (n == 0) return cell;
    const std::int32_t rest = cell % n;
    return rest < 0 ? rest + n : rest;
  }

  Cell<D> wrapped(Cell<D> cell) const {
    for (int a = 0; a < D; ++a) cell[a] = wrapped(a, cell[a]);
    return cell;
  }

  bool is_periodic() const {
    for (int a = 0; a < D; ++a) {
      if (period[a] != 0) return true;
    }
    return false;
  }

  bool is_wrapped(const Cell<D>& cell) const {
    for (int a = 0; a < D; ++a) {
      if (period[a] != 0 && (cell[a] < 0 || cell[a] >= period[a])) return false;
    }
    return true;
  }
};

}  // namespace pliant

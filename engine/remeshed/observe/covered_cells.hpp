#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/boundaries/walls.hpp"
#include "engine/remeshed/state/lattice_view.hpp"
#include "kernels/layout.hpp"

namespace pliant::remeshed {

constexpr int sub_cells = 10;          ///< along a side of a cell that the surface may cut
constexpr double coverage_slope = 10;  ///< (RP.42)

/// Integrals of the coverage of a cell, and of the coverage times s_a, s_a s_b and s_a s_b s_c,
/// with s in [-1/2, 1/2]^D.
template <int D>
struct Moments {
  using Row = std::array<double, sub_cells>;

  double zeroth = 0;
  Point<D> first = {};
  std::array<Point<D>, D> second = {};
  std::array<std::array<Point<D>, D>, D> third = {};

  static Moments of_whole_cell() {
    Moments whole;
    whole.zeroth = 1;
    for (int a = 0; a < D; ++a) whole.second[a][a] = 1.0 / 12;
    return whole;
  }

  /// Place of a sub-cell along an axis, in [-1/2, 1/2] cells.
  static constexpr double centre(int i) { return (i + 0.5) / sub_cells - 0.5; }
  static constexpr std::array<std::array<double, 4>, sub_cells> powers_of_centres() {
    std::array<std::array<double, 4>, sub_cells> powers = {};
    for (int i = 0; i < sub_cells; ++i) {
      const double s = centre(i);
      powers[i] = {1, s, s * s, s * s * s};
    }
    return powers;
  }

  /// Sums over the sub-cells of a row along the first axis, times 1, s_0, s_0^2, s_0^3.
  using RowSums = std::array<double, 4>;
  static RowSums sums_of(const Row& weights) {
    static constexpr std::array<RowSums, sub_cells> powers = powers_of_centres();
    RowSums sums = {};
    for (int i = 0; i < sub_cells; ++i) {
      for (int n = 0; n < 4; ++n) sums[n] += weights[i] * powers[i][n];
    }
    for (double& sum : sums) sum /= kernels::power(sub_cells, D);
    return sums;
  }
  static RowSums sums_of_whole_row() {
    Row whole;
    whole.fill(1);
    return sums_of(whole);
  }

  /// Sums over the rows of a plane across the last axis, times s_0^n s_1^m, n + m <= 3. In 2D there
  /// is one plane.
  struct PlaneSums {
    double sum[4][4] = {};

    /// `t` is the position of the row along the second axis.
    void add_row(const RowSums& row, double t) {
      double power = 1;
      for (int m = 0; m < 4; ++m, power *= t) {
        for (int n = 0; n + m < 4; ++n) sum[n][m] += power * row[n];
      }
    }
  };

  /// Adds a plane; `t` is its position along the third axis. Of symmetric components, only those
  /// with rising indices are summed.
  void add_plane(const PlaneSums& plane, double t) {
    const std::array<double, 4> power = {1, t, t * t, t * t * t};
    zeroth += plane.sum[0][0];
    for (int a = 0; a < D; ++a) {
      first[a] += plane.sum[a == 0][a == 1] * power[a == 2];
      for (int b = a; b < D; ++b) {
        second[a][b] +=
            plane.sum[(a == 0) + (b == 0)][(a == 1) + (b == 1)] * power[(a == 2) + (b == 2)];
        for (int c = b; c < D; ++c) {
          third[a][b][c] +=
              plane.sum[(a == 0) + (b == 0) + (c == 0)][(a == 1) + (b == 1) + (c == 1)] *
              power[(a == 2) + (b == 2) + (c == 2)];
        }
      }
    }
  }

  /// Copies the sums to the other components.
  void complete() {
    for (int a = 0; a < D; ++a) {
      for (int b = 0; b < D; ++b) {
        second[a][b] = second[std::min(a, b)][std::max(a, b)];
        for (int c = 0; c < D; ++c) {
          std::array<int, 3> rising = {a, b, c};
          std::ranges::sort(rising);
          third[a][b][c] = third[rising[0]][rising[1]][rising[2]];
        }
      }
    }
  }
};

/// The cells around the nodes of a body, and the part of each that the body covers in front of all
/// walls, (RP.42).
template <class T, int D>
class CoveredCells {
 public:
  CoveredCells(const LatticeView<T, D>& view, const Boundaries<D>& boundaries)
      : view_(view), boundaries_(boundaries), h_(view.body.lattice.spacing) {}

  /// Calls f(slot, cell, moments) for the cells of a block that the body may cover.
  template <class F>
  void for_each(const Block<D>& block, F&& f) const {
    const T* phi = view_.fields.get(Field::level_set);
    const double reach = 0.5 * std::sqrt(static_cast<double>(D)) + 0.2;
    view_.population.layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
      if (!holds_particle(p) || !view_.body.lattice.is_wrapped(cell)) return;
      const double distance = phi[p] / h_;
      if (distance > reach) return;
      const Point<D> x = view_.body.lattice.node(cell);
      const double wall = distance_to_walls(x) / h_;
      if (wall < -reach) return;
      const bool is_whole = distance < -reach && wall > reach;
      f(p, cell, is_whole ? whole_ : covered(x, expand(p, cell), wall < reach));
    });
  }

  /// Calls f(axis, up, down) with the slots on both sides of a node, for each axis that has both.
  template <class F>
  void for_each_pair(const Cell<D>& cell, F&& f) const {
    for (int a = 0; a < D; ++a) {
      const std::int64_t up = neighbour(cell, a, 1), down = neighbour(cell, a, -1);
      if (holds_particle(up) && holds_particle(down)) f(a, up, down);
    }
  }

 private:
  using Row = typename Moments<D>::Row;

  /// phi to second order around a node [h]; places are in cells.
  struct Expansion {
    double phi = 0;
    Point<D> slope = {};
    std::array<Point<D>, D> curvature = {};
  };

  double distance_to_walls(const Point<D>& x) const {
    return std::min(boundaries_.nearest_wall(x).second, boundaries_.nearest_contact(x).second);
  }

  std::int64_t neighbour(Cell<D> cell, int axis, int step) const {
    cell[axis] += step;
    return view_.population.layout.slot(view_.body.lattice.wrapped(cell));
  }

  bool holds_particle(std::int64_t p) const {
    return p >= 0 && view_.population.kind[p] != Kind::vacant;
  }

  Expansion expand(std::int64_t p, const Cell<D>& cell) const {
    const T* phi = view_.fields.get(Field::level_set);
    Expansion e;
    e.phi = phi[p] / h_;
    for (int a = 0; a < D; ++a) {
      const std::int64_t up = neighbour(cell, a, 1), down = neighbour(cell, a, -1);
      if (up < 0 || down < 0) continue;
      e.slope[a] = (phi[up] - phi[down]) / (2 * h_);
      e.curvature[a][a] = (phi[up] - 2 * phi[p] + phi[down]) / h_;
      for (int b = a + 1; b < D; ++b) {
        e.curvature[a][b] = e.curvature[b][a] = mixed(cell, a, b, phi);
      }
    }
    return e;
  }

  double mixed(Cell<D> cell, int a, int b, const T* phi) const {
    double sum = 0;
    for (const int i : {-1, 1}) {
      for (const int j : {-1, 1}) {
        Cell<D> corner = cell;
        corner[a] += i;
        corner[b] += j;
        const std::int64_t q = view_.population.layout.slot(view_.body.lattice.wrapped(corner));
        if (q < 0) return 0;
        sum += i * j * phi[q];
      }
    }
    return sum / (4 * h_);
  }

  Moments<D> covered(const Point<D>& x, const Expansion& e, bool is_near_wall) const {
    Moments<D> moments;
    for (int k = 0; k < kernels::power(sub_cells, D - 2); ++k) {
      Point<D> t = {};
      if constexpr (D == 3) t[2] = Moments<D>::centre(k);
      typename Moments<D>::PlaneSums plane;
      for (int j = 0; j < sub_cells; ++j) {
        t[1] = Moments<D>::centre(j);
        Row row;
        Cover cover = cover_by_body(e, t, row);
        if (is_near_wall && cover != Cover::nothing) cover = leave_out_walls(x, t, row, cover);
        if (cover == Cover::nothing) continue;
        plane.add_row(cover == Cover::all ? whole_row_ : Moments<D>::sums_of(row), t[1]);
      }
      moments.add_plane(plane, D == 3 ? t[D - 1] : 0);
    }
    moments.complete();
    return moments;
  }

  /// How much of a row is covered. If only some of it is, its sub-cells are set.
  enum class Cover { nothing, some, all };

  static Cover cover_by_body(const Expansion& e, const Point<D>& t, Row& row) {
    double phi = e.phi, slope = e.slope[0];  // at the middle of the row
    for (int a = 1; a < D; ++a) {
      phi += e.slope[a] * t[a];
      slope += e.curvature[0][a] * t[a];
      for (int b = 1; b < D; ++b) phi += 0.5 * e.curvature[a][b] * t[a] * t[b];
    }
    const double across = 0.5 * std::abs(slope) + 0.125 * std::abs(e.curvature[0][0]);
    if (phi - across > edge) return Cover::nothing;
    if (phi + across < -edge) return Cover::all;
    for (int i = 0; i < sub_cells; ++i) {
      const double s = Moments<D>::centre(i);
      const double at = phi + s * (slope + 0.5 * e.curvature[0][0] * s);
      row[i] = std::clamp(0.5 - coverage_slope * at, 0.0, 1.0);
    }
    return Cover::some;
  }

  // The distance from a wall changes by no more than the distance between places.
  Cover leave_out_walls(const Point<D>& x, const Point<D>& t, Row& row, Cover cover) const {
    Point<D> at = x;
    for (int a = 1; a < D; ++a) at[a] += h_ * t[a];
    const double middle = distance_to_walls(at) / h_;
    if (middle >= 0.5 + edge) return cover;
    if (middle <= -0.5 - edge) return Cover::nothing;
    if (cover == Cover::all) row.fill(1);
    for (int i = 0; i < sub_cells; ++i) {
      if (row[i] == 0) continue;
      at[0] = x[0] + h_ * Moments<D>::centre(i);
      row[i] *= std::clamp(0.5 + coverage_slope * distance_to_walls(at) / h_, 0.0, 1.0);
    }
    return Cover::some;
  }

  static constexpr double edge =
      0.5 / coverage_slope;  ///< half the width over which coverage changes [h]

  LatticeView<T, D> view_;
  const Boundaries<D>& boundaries_;
  double h_;
  Moments<D> whole_ = Moments<D>::of_whole_cell();
  typename Moments<D>::RowSums whole_row_ = Moments<D>::sums_of_whole_row();
};

}  // namespace pliant::remeshed

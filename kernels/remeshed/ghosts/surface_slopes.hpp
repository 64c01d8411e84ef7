#pragma once

#include "kernels/marks.hpp"
#include "kernels/remeshed/ghosts/arguments.hpp"
#include "kernels/remeshed/stage/moment.hpp"

/// grad phi of surface particles, (RP.61): the gradient of phi on the lattice, transformed by the
/// deformation gradient F since the last remeshing. F is fitted to the drift of the interior
/// particles around. With differences between single particles, short waves would turn the normals:
/// the gradients of (RP.20) do not see them, so no stress resists them, and they buckle under
/// compression.
namespace pliant::kernels {

/// The fit takes particles within 3.6 h on the lattice, where squared distances are whole numbers.
inline constexpr double slope_radius_squared = 3.6 * 3.6;
inline constexpr int largest_slope_square = 12;
static_assert(largest_slope_square < slope_radius_squared &&
              largest_slope_square + 1 > slope_radius_squared);

/// For each squared distance over h: the weight, and how many cells a row at that distance extends
/// to each side.
template <class T>
struct SlopeStencil {
  T weight[largest_slope_square + 1] = {};
  int half_width[largest_slope_square + 1] = {};

  constexpr SlopeStencil() {
    for (int square = 0; square <= largest_slope_square; ++square) {
      const double t = 1 - square / slope_radius_squared;
      weight[square] = static_cast<T>(t * t);
      int& cells = half_width[square];
      while ((cells + 1) * (cells + 1) + square <= largest_slope_square) ++cells;
    }
  }
};
template <class T>
inline constexpr SlopeStencil<T> slope_stencil = {};

/// A vector normal to two rows.
template <class P>
inline void normal_to(const P (&a)[3], const P (&b)[3], P (&normal)[3]) {
  normal[0] = fused_minus(a[2], b[1], a[1] * b[2]);
  normal[1] = fused_minus(a[0], b[2], a[2] * b[0]);
  normal[2] = fused_minus(a[1], b[0], a[0] * b[1]);
}

/// The gradient whose products with the rows are `rise`.
template <class P>
inline void solve_slopes(const P (&row)[2][2], const P (&rise)[2], P (&gradient)[2]) {
  const P determinant = fused_minus(row[0][1], row[1][0], row[0][0] * row[1][1]);
  const P factor = P(Scalar<P>(1)) / determinant;
  gradient[0] = factor * fused_minus(rise[1], row[0][1], rise[0] * row[1][1]);
  gradient[1] = factor * fused_minus(rise[0], row[1][0], rise[1] * row[0][0]);
}

template <class P>
inline void solve_slopes(const P (&row)[3][3], const P (&rise)[3], P (&gradient)[3]) {
  P normal[3][3];
#pragma GCC unroll 3
  for (int j = 0; j < 3; ++j) normal_to(row[(j + 1) % 3], row[(j + 2) % 3], normal[j]);
  P determinant = row[0][0] * normal[0][0];
#pragma GCC unroll 2
  for (int i = 1; i < 3; ++i) determinant = fused(row[0][i], normal[0][i], determinant);
  const P factor = P(Scalar<P>(1)) / determinant;
#pragma GCC unroll 3
  for (int i = 0; i < 3; ++i) {
    P sum = rise[0] * normal[0][i];
#pragma GCC unroll 2
    for (int j = 1; j < 3; ++j) sum = fused(rise[j], normal[j][i], sum);
    gradient[i] = factor * sum;
  }
}

/// Weighted sums over the interior particles around a register of particles. R are distances on the
/// lattice over h, d their changes since the last remeshing.
template <class P, int D>
struct SlopeSums {
  P weight, offset[D], moment[symmetric_components<D>];  ///< sums of w, w R, w R R^T
  P motion[D], product[D][D];                            ///< sums of w d, w d R^T

  SlopeSums() {
    const P zero(Scalar<P>(0));
    weight = zero;
    for (P& m : moment) m = zero;
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) {
      offset[i] = motion[i] = zero;
      for (P& m : product[i]) m = zero;
    }
  }

  /// Adds the cells of a row, offset by `row` cells in the directions after the first.
  void add_row(const SlopeSums& cells, const P (&row)[D - 1]) {
    weight = weight + cells.weight;
    offset[0] = offset[0] + cells.offset[0];
    moment[0] = moment[0] + cells.moment[0];
#pragma GCC unroll 2
    for (int j = 1; j < D; ++j) {
      offset[j] = fused(row[j - 1], cells.weight, offset[j]);
      P& mixed = moment[symmetric_index<D>(0, j)];
      mixed = fused(row[j - 1], cells.offset[0], mixed);
#pragma GCC unroll 2
      for (int k = j; k < D; ++k) {
        P& both = moment[symmetric_index<D>(j, k)];
        both = fused(row[j - 1] * row[k - 1], cells.weight, both);
      }
    }
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) {
      motion[i] = motion[i] + cells.motion[i];
      product[i][0] = product[i][0] + cells.product[i][0];
#pragma GCC unroll 2
      for (int j = 1; j < D; ++j) {
        product[i][j] = fused(row[j - 1], cells.motion[i], product[i][j]);
      }
    }
  }
};

/// The sums of one row, relative to its own middle.
template <class P, int D>
inline void sum_slope_row(const SurfaceRecords<Scalar<P>, D>& block, std::int64_t middle,
                          int square, const P (&own)[D], SlopeSums<P, D>& cells) {
  using T = Scalar<P>;
  const P lead(block.lead);
  const int half_width = slope_stencil<T>.half_width[square];
  for (int x = -half_width; x <= half_width; ++x) {
    const std::int64_t slot = middle + x;
    const P w = P(slope_stencil<T>.weight[x * x + square]) * load_marks<P>(block.interior + slot);
    const P along(static_cast<T>(x)), w_along = w * along;
    cells.weight = cells.weight + w;
    cells.offset[0] = cells.offset[0] + w_along;
    cells.moment[0] = fused(along, w_along, cells.moment[0]);
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) {
      const P d = fused(lead, load<P>(block.state.velocity[i] + slot),
                        load<P>(block.state.drift[i] + slot) - own[i]);
      cells.motion[i] = fused(w, d, cells.motion[i]);
      cells.product[i][0] = fused(w_along, d, cells.product[i][0]);
    }
  }
}

template <class P, int D>
inline SlopeSums<P, D> slope_sums(const SurfaceRecords<Scalar<P>, D>& block,
                                  const Segment<D>& segment, std::int64_t slot) {
  using T = Scalar<P>;
  P own[D];
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) own[i] = load<P>(block.state.drift[i] + slot);
  SlopeSums<P, D> sums;
  constexpr int reach = row_reach, reach_z = D == 3 ? reach : 0;
  for (int z = -reach_z; z <= reach_z; ++z) {
    for (int y = -reach; y <= reach; ++y) {
      const int square = y * y + z * z;
      if (square > largest_slope_square) continue;
      SlopeSums<P, D> cells;
      sum_slope_row(block, slot + segment.neighbour_row[row_index<D>(y, z)], square, own, cells);
      P row[D - 1];
      row[0] = P(static_cast<T>(y));
      if constexpr (D == 3) row[1] = P(static_cast<T>(z));
      sums.add_row(cells, row);
    }
  }
  return sums;
}

/// sum w R R^T about the mean of R. If the particles lie on a line or in a plane, it is
/// regularised, so that F = I in directions without any particle.
template <class P, int D>
inline void slope_moment(const SlopeSums<P, D>& sums, P (&moment)[symmetric_components<D>]) {
  using T = Scalar<P>;
  const P share = P(T(1)) / sums.weight, least(T(0.01));
#pragma GCC unroll 3
  for (int j = 0; j < D; ++j) {
#pragma GCC unroll 3
    for (int k = j; k < D; ++k) {
      const int at = symmetric_index<D>(j, k);
      moment[at] = fused_minus(share * sums.offset[j], sums.offset[k], sums.moment[at]);
    }
  }
  const P addition = xsimd::select(symmetric_determinant(moment) > least, P(T(0)), least);
#pragma GCC unroll 3
  for (int j = 0; j < D; ++j) {
    P& square = moment[symmetric_index<D>(j, j)];
    square = square + addition;
  }
}

/// F of (RP.61).
template <class P, int D>
inline void fit_deformation(const SlopeSums<P, D>& sums, Scalar<P> spacing, P (&f)[D][D]) {
  using T = Scalar<P>;
  P moment[symmetric_components<D>], inverse[symmetric_components<D>];
  slope_moment(sums, moment);
  invert_symmetric(moment, inverse);
  const P share = P(T(1)) / sums.weight, scale(T(1) / spacing);
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
    P product[D];
#pragma GCC unroll 3
    for (int k = 0; k < D; ++k) {
      const P about_mean = fused_minus(share * sums.motion[i], sums.offset[k], sums.product[i][k]);
      product[k] = scale * about_mean;
    }
#pragma GCC unroll 3
    for (int j = 0; j < D; ++j) {
      f[i][j] = P(T(i == j ? 1 : 0));
#pragma GCC unroll 3
      for (int k = 0; k < D; ++k) {
        f[i][j] = fused(product[k], inverse[symmetric_index<D>(k, j)], f[i][j]);
      }
    }
  }
}

/// grad phi by (RP.61) of the register of particles at `slot`.
template <class P, int D>
inline void level_set_gradient(const SurfaceRecords<Scalar<P>, D>& block, const Segment<D>& segment,
                               std::int64_t slot, P (&gradient)[D]) {
  using T = Scalar<P>;
  P f[D][D], row[D][D], rise[D];
  fit_deformation(slope_sums<P, D>(block, segment, slot), block.spacing, f);
  const P scale(T(0.5) / block.spacing);
#pragma GCC unroll 3
  for (int j = 0; j < D; ++j) {
    std::int64_t up = 1, down = -1;
    if (j > 0) {
      up = segment.neighbour_row[j == 1 ? row_index<D>(1) : row_index<D>(0, 1)];
      down = segment.neighbour_row[j == 1 ? row_index<D>(-1) : row_index<D>(0, -1)];
    }
    rise[j] =
        scale * (load<P>(block.level_set + slot + up) - load<P>(block.level_set + slot + down));
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) row[j][i] = f[i][j];
  }
  solve_slopes(row, rise, gradient);
}

}  // namespace pliant::kernels

#pragma once

#include "kernels/law.hpp"
#include "kernels/pack.hpp"
#include "kernels/remeshed/ghosts/arguments.hpp"

namespace pliant::kernels {

/// Records of up to one storage pack, field by field.
template <class T, int D>
struct RecordColumns {
  alignas(64) T field[record_width<D>][slots_per_pack] = {};
};

/// Cross product of two rows, or the row turned by -90 degrees in the plane: normal to both.
template <class P>
inline void normal_to(const P (&a)[3], const P (&b)[3], P (&normal)[3]) {
  normal[0] = fused_minus(a[2], b[1], a[1] * b[2]);
  normal[1] = fused_minus(a[0], b[2], a[2] * b[0]);
  normal[2] = fused_minus(a[1], b[0], a[0] * b[1]);
}

/// (RP.61) from the rows x_+j - x_-j and phi_+j - phi_-j.
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

/// (RP.61) of the register of particles at `slot`.
template <class P, int D>
inline void level_set_gradient(const SurfaceRecords<Scalar<P>, D>& block, const Segment<D>& segment,
                               std::int64_t slot, P (&gradient)[D]) {
  using T = Scalar<P>;
  const std::int64_t along[3] = {1, segment.neighbour_row[row_index<D>(1)],
                                 D == 3 ? segment.neighbour_row[row_index<D>(0, 1)] : 0};
  const std::int64_t back[3] = {-1, segment.neighbour_row[row_index<D>(-1)],
                                D == 3 ? segment.neighbour_row[row_index<D>(0, -1)] : 0};
  P row[D][D], rise[D];
#pragma GCC unroll 3
  for (int j = 0; j < D; ++j) {
    const auto difference = [&](const T* field) {
      return load<P>(field + slot + along[j]) - load<P>(field + slot + back[j]);
    };
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) {
      row[j][i] = difference(block.state.drift[i]);
      if (i == j) row[j][i] = row[j][i] + P(2 * block.spacing);
    }
    rise[j] = difference(block.level_set);
  }
  solve_slopes(row, rise, gradient);
}

/// Fills the columns of the register of particles at `slot`, lanes `at` and up of its pack.
template <Model model, class P, int D>
inline void fill_columns(const SurfaceRecords<Scalar<P>, D>& block, const Segment<D>& segment,
                         std::int64_t slot, int at, RecordColumns<Scalar<P>, D>& columns) {
  using L = Law<model, P, D>;
  P gradient[D];
  level_set_gradient<P, D>(block, segment, slot, gradient);
  P carried[L::components];
#pragma GCC unroll 9
  for (int c = 0; c < L::components; ++c) carried[c] = load<P>(block.state.material[c] + slot);
  const P density = load<P>(block.mass + slot) / load<P>(block.state.volume + slot);

  using Place = RecordPlace<D>;
  const auto put = [&](int f, const P& value) { value.store_aligned(&columns.field[f][at]); };
#pragma GCC unroll 6
  for (int c = 0; c < symmetric_components<D>; ++c) {
    put(Place::stress + c, load<P>(block.stress[c] + slot));
  }
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
    put(Place::velocity + i, load<P>(block.state.velocity[i] + slot));
    put(Place::slope + i, gradient[i]);
  }
  P pressure = L::pressure(block.material, carried, density);
  if constexpr (model == Model::reduced_polynomial) {
    // What relaxes is known from the stress alone: p_i are those of the start of the step.
    if (block.relaxes) {
      P elastic[symmetric_components<D>];
      L::stress(block.material, carried, density, elastic);
      pressure = pressure + elastic[0] - load<P>(block.stress[0] + slot);
    }
  }
  put(Place::pressure, pressure);
}

template <Model model, class P, int D>
void write_records(const SurfaceRecords<Scalar<P>, D>& block) {
  using T = Scalar<P>;
  RecordColumns<T, D> columns;
  for (int k = 0; k < block.pack_count; ++k) {
    const SurfacePack& pack = block.packs[k];
    for (int at = 0; at < slots_per_pack; at += lanes<P>) {
      if ((pack.lanes >> at & ((1u << lanes<P>)-1)) == 0) continue;
      fill_columns<model, P, D>(block, block.segments[pack.segment], pack.first + at, at, columns);
    }
    T* record = block.records + static_cast<std::int64_t>(pack.record) * record_width<D>;
    for (int l = 0; l < slots_per_pack; ++l) {
      if ((pack.lanes >> l & 1u) == 0) continue;
      for (int f = 0; f < record_width<D>; ++f) record[f] = columns.field[f][l];
      record += record_width<D>;
    }
  }
}

/// See SurfaceRecords.
template <class P, int D>
void write_surface_records(const SurfaceRecords<Scalar<P>, D>& block) {
  switch (block.material.model) {
    case Model::linear_rho:
      return write_records<Model::linear_rho, P, D>(block);
    case Model::linear_log:
      return write_records<Model::linear_log, P, D>(block);
    case Model::reduced_polynomial:
      return write_records<Model::reduced_polynomial, P, D>(block);
  }
}

}  // namespace pliant::kernels

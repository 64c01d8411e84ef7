#pragma once

#include "kernels/gradient_sweep.hpp"
#include "kernels/law.hpp"
#include "kernels/table.hpp"

namespace pliant::kernels {

/// Records of up to one storage pack, field by field.
template <class T, int D>
struct RecordColumns {
  alignas(64) T field[record_fields<D>][slots_per_pack<T>];
};

/// Fills the columns of the register of particles at `slot`, lanes `at` and up of its pack.
template <Weight weight, Model model, class P, int D>
inline void fill_columns(const SurfaceRecords<Scalar<P>, D>& block, const Segment<D>& segment,
                         std::int64_t slot, int at, RecordColumns<Scalar<P>, D>& columns) {
  using T = Scalar<P>;
  using L = Law<model, P, D>;
  SweepFields<T, D, 1> fields;
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) fields.displacement[i] = block.state.displacement[i];
  fields.field[0] = block.level_set;
  P gradient[1][D];
  GradientSums<P, D, 1> sums;
  sweep_stencil<weight>(fields, segment.neighbour_row.data(), slot, block.spacing, sums);
  solve(sums, gradient);
  P carried[L::components];
#pragma GCC unroll 9
  for (int c = 0; c < L::components; ++c) carried[c] = load<P>(block.state.material[c] + slot);
  const P density = load<P>(block.mass + slot) / load<P>(block.state.volume + slot);

  int f = 0;
  const auto put = [&](const P& value) { value.store_aligned(&columns.field[f++][at]); };
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) put(load<P>(block.state.velocity[i] + slot));
#pragma GCC unroll 6
  for (int c = 0; c < symmetric_components<D>; ++c) put(load<P>(block.stress[c] + slot));
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) put(gradient[0][i]);
  P pressure = L::pressure(block.material, carried, density);
  if constexpr (model == Model::reduced_polynomial) {
    // What relaxes is known from the stress alone: p_i are those of the start of the step.
    if (block.relaxes) {
      P elastic[symmetric_components<D>];
      L::stress(block.material, carried, density, elastic);
      pressure = pressure + elastic[0] - load<P>(block.stress[0] + slot);
    }
  }
  put(pressure);
}

template <Weight weight, Model model, class P, int D>
void write_records(const SurfaceRecords<Scalar<P>, D>& block) {
  using T = Scalar<P>;
  RecordColumns<T, D> columns;
  for (int k = 0; k < block.pack_count; ++k) {
    const SurfacePack& pack = block.packs[k];
    for (int at = 0; at < slots_per_pack<T>; at += lanes<P>) {
      if ((pack.lanes >> at & ((1u << lanes<P>)-1)) == 0) continue;
      fill_columns<weight, model, P, D>(block, block.segments[pack.segment], pack.first + at, at,
                                        columns);
    }
    T* record = block.records + static_cast<std::int64_t>(pack.record) * record_width<D>;
    for (int l = 0; l < slots_per_pack<T>; ++l) {
      if ((pack.lanes >> l & 1u) == 0) continue;
      for (int f = 0; f < record_width<D>; ++f) {
        record[f] = f < record_fields<D> ? columns.field[f][l] : T(0);
      }
      record += record_width<D>;
    }
  }
}

template <Weight weight, class P, int D>
void write_records_by_model(const SurfaceRecords<Scalar<P>, D>& block) {
  switch (block.material.model) {
    case Model::linear_rho:
      return write_records<weight, Model::linear_rho, P, D>(block);
    case Model::linear_log:
      return write_records<weight, Model::linear_log, P, D>(block);
    case Model::reduced_polynomial:
      return write_records<weight, Model::reduced_polynomial, P, D>(block);
  }
}

/// See SurfaceRecords.
template <class P, int D>
void write_surface_records(const SurfaceRecords<Scalar<P>, D>& block) {
  switch (block.weight) {
    case Weight::quartic:
      return write_records_by_model<Weight::quartic, P, D>(block);
    case Weight::quartic_polynomial:
    case Weight::fourth_order:  // negative weights gain nothing beside a surface
      return write_records_by_model<Weight::quartic_polynomial, P, D>(block);
    case Weight::compact:
      return write_records_by_model<Weight::compact, P, D>(block);
  }
}

}  // namespace pliant::kernels

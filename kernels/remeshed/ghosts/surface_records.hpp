#pragma once

#include "kernels/law.hpp"
#include "kernels/pack.hpp"
#include "kernels/remeshed/ghosts/arguments.hpp"
#include "kernels/remeshed/ghosts/surface_slopes.hpp"

namespace pliant::kernels {

/// Records of up to one storage pack, field by field.
template <class T, int D>
struct RecordColumns {
  alignas(64) T field[record_width<D>][slots_per_pack] = {};
};

/// Computes the columns of the register of particles at `slot`, from lane `at` of its pack on.
template <Model model, class P, int D>
inline void fill_columns(const SurfaceRecords<Scalar<P>, D>& block, const Segment<D>& segment,
                         std::int64_t slot, int at, RecordColumns<Scalar<P>, D>& columns) {
  using L = Law<model, P, D>;
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
  }
  P pressure = L::pressure(block.material, carried, density);
  if constexpr (model == Model::reduced_polynomial) {
    // The relaxed pressure follows from the stress: the stored p_i are those of the start of the
    // step.
    if (block.relaxes) {
      P elastic[symmetric_components<D>];
      L::stress(block.material, carried, density, elastic);
      pressure = pressure + elastic[0] - load<P>(block.stress[0] + slot);
    }
  }
  put(Place::pressure, pressure);
  if (!block.renews_slopes) return;
  P gradient[D];
  level_set_gradient<P, D>(block, segment, slot, gradient);
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) put(Place::slope + i, gradient[i]);
}

template <Model model, class P, int D>
void write_records(const SurfaceRecords<Scalar<P>, D>& block) {
  using T = Scalar<P>;
  constexpr int slope = RecordPlace<D>::slope;
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
      for (int f = 0; f < slope; ++f) record[f] = columns.field[f][l];
      if (block.renews_slopes) {
        for (int f = slope; f < record_width<D>; ++f) record[f] = columns.field[f][l];
      }
      record += record_width<D>;
    }
  }
}

template <class P, int D>
void write_surface_records(const SurfaceRecords<Scalar<P>, D>& block) {
  with_model(block.material.model, [&]<Model model>() { write_records<model, P, D>(block); });
}

}  // namespace pliant::kernels

#pragma once

#include "kernels/chunk.hpp"
#include "kernels/fourth_difference.hpp"
#include "kernels/gradient_sweep.hpp"

/// The dissipation of (RP.43): fourth differences of velocity and stress along the lattice lines,
/// which only see what the lattice does not resolve.
namespace pliant::kernels {

/// Whether all slots of the pack of `slot` and the two slots before and behind each along a line
/// are interior; never wrongly so.
template <class P>
inline bool line_is_interior(const PackState* pack_state, std::int64_t slot, int axis,
                             const LineOffsets& line) {
  constexpr int pack = slots_per_pack<Scalar<P>>;
  const std::int64_t own = slot / pack;
  bool is_interior = pack_state[own] == PackState::all;
  for (int k = 0; k < 4; ++k) {
    const std::int64_t other = axis == 0 ? own + (k < 2 ? -1 : 1) : (slot + line.away[k]) / pack;
    is_interior = is_interior && pack_state[other] == PackState::all;
  }
  return is_interior;
}

/// Sums over the directions of delta^4 of the sweep's fields in a chunk, field by field, between
/// interior particles.
template <class P, int D, int F>
void fourth_differences(const SweepFields<Scalar<P>, D, F>& fields, const Segment<D>& segment,
                        const PackState* pack_state, const Scalar<P>* interior, const Chunk& chunk,
                        Scalar<P> (&result)[F][chunk_slots]) {
  LineOffsets line[D];
  for (int axis = 0; axis < D; ++axis) {
    line[axis] = line_offsets<typename P::arch_type>(segment, axis);
  }
  for (int at = 0; at < chunk.count; at += lanes<P>) {
    const std::int64_t slot = chunk.first + at;
    for (int axis = 0; axis < D; ++axis) {
      if (line_is_interior<P>(pack_state, slot, axis, line[axis])) {
#pragma GCC unroll 9
        for (int f = 0; f < F; ++f) {
          const P sum = axis == 0 ? P(Scalar<P>(0)) : P::load_aligned(&result[f][at]);
          (sum + fourth_difference_inside<P>(fields.field[f] + slot, line[axis]))
              .store_aligned(&result[f][at]);
        }
        continue;
      }
      const Fluxes<P> fluxes = fluxes_between<P>(interior + slot, line[axis]);
#pragma GCC unroll 9
      for (int f = 0; f < F; ++f) {
        const P sum = axis == 0 ? P(Scalar<P>(0)) : P::load_aligned(&result[f][at]);
        (sum + fourth_difference<P>(fields.field[f] + slot, line[axis], fluxes))
            .store_aligned(&result[f][at]);
      }
    }
  }
}

/// The strain rate that relaxes the stress at the rate -kappa delta^4 sigma: Hooke's law inverted.
/// A material that remembers its deformation (F) relaxes the pressure alone: relaxing its shear
/// would be creep.
template <class P, int D>
inline void relaxing_strain_rate(const Material<Scalar<P>>& material, Scalar<P> kappa,
                                 const P (&difference)[symmetric_components<D>],
                                 P (&strain_rate)[symmetric_components<D>]) {
  using T = Scalar<P>;
  const T shear = material.shear_modulus;
  const T lame = material.bulk_modulus - shear * T(2) / T(3);
  P trace = difference[0];
#pragma GCC unroll 3
  for (int i = 1; i < D; ++i) trace = trace + difference[symmetric_index<D>(i, i)];
  const P mean = trace * P(T(1) / T(D));
  const P volumetric = mean * P(-kappa / (T(D) * lame + 2 * shear));
  const P scale(material.model == Model::reduced_polynomial ? T(0) : -kappa / (2 * shear));
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
#pragma GCC unroll 3
    for (int j = i; j < D; ++j) {
      const P& d = difference[symmetric_index<D>(i, j)];
      strain_rate[symmetric_index<D>(i, j)] =
          i == j ? fused(scale, d - mean, volumetric) : scale * d;
    }
  }
}

}  // namespace pliant::kernels

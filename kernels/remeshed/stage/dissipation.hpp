#pragma once

#include "kernels/remeshed/stage/chunk.hpp"
#include "kernels/remeshed/stage/fourth_difference.hpp"
#include "kernels/remeshed/stage/gradient_sweep.hpp"
#include "kernels/remeshed/stage/prefetch.hpp"

/// The dissipation of (RP.23): fourth differences of velocity and stress along the lattice lines,
/// which only see what the lattice does not resolve.
namespace pliant::kernels {

/// Whether every flux flows between the interior particles of a pack and their neighbours.
template <class P, int D>
inline bool flow_everywhere(const Scalar<P>* interior, const LineOffsets (&line)[D]) {
  const P half(Scalar<P>(0.5));
  bool flow = true;
  for (int at = 0; at < slots_per_pack; at += lanes<P>) {
    P near(Scalar<P>(1));
#pragma GCC unroll 3
    for (const LineOffsets& l : line) {
      near = near * load<P>(interior + at + l.away[1]) * load<P>(interior + at + l.away[2]);
    }
    flow = flow && xsimd::all(near > half || load<P>(interior + at) < half);
  }
  return flow;
}

/// Sums over the directions of delta^4 of the sweep's fields in a chunk, field by field, between
/// interior particles; anything finite in other slots.
template <class P, int D, int F>
void fourth_differences(const SweepFields<Scalar<P>, D, F>& fields, const Segment<D>& segment,
                        const Scalar<P>* interior, const Chunk& chunk,
                        Scalar<P> (&result)[F][chunk_slots]) {
  constexpr int pack = slots_per_pack;
  LineOffsets line[D];
  for (int axis = 0; axis < D; ++axis) {
    line[axis] = line_offsets<typename P::arch_type>(segment, axis);
  }
  for (int begin = 0; begin < chunk.count; begin += pack) {
    prefetch_ahead<P>(fields.field, chunk.first + begin + line[D - 1].away[3]);
    const bool flow = flow_everywhere<P>(interior + chunk.first + begin, line);
    for (int at = begin; at < begin + pack; at += lanes<P>) {
      const std::int64_t slot = chunk.first + at;
      if (flow) {
#pragma GCC unroll 9
        for (int f = 0; f < F; ++f) {
          fourth_differences_inside<P>(fields.field[f] + slot, line).store_aligned(&result[f][at]);
        }
        continue;
      }
      Fluxes<P> fluxes[D];
#pragma GCC unroll 3
      for (int axis = 0; axis < D; ++axis) {
        fluxes[axis] = fluxes_between<P>(interior + slot, line[axis]);
      }
#pragma GCC unroll 9
      for (int f = 0; f < F; ++f) {
        fourth_differences(fields.field[f] + slot, line, fluxes).store_aligned(&result[f][at]);
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

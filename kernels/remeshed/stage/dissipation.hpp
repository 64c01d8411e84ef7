#pragma once

#include "kernels/remeshed/stage/chunk.hpp"
#include "kernels/remeshed/stage/fourth_difference.hpp"
#include "kernels/remeshed/stage/gradient_sweep.hpp"
#include "kernels/remeshed/stage/prefetch.hpp"
#include "kernels/remeshed/stage/sixth_difference.hpp"

/// The dissipation of (RP.23): differences of velocity, place and stress along lattice lines, which
/// only see what the lattice does not resolve. Those of the place are the gradient of an energy,
/// the sum of squared second differences, and so cannot amplify anything.
namespace pliant::kernels {

/// Whether all fluxes between the particles of a pack and their neighbours are between interior
/// particles.
template <class P, int D>
inline bool flow_everywhere(const Mark* interior, const LineOffsets (&line)[D]) {
  const P half(Scalar<P>(0.5));
  bool flow = true;
  for (int at = 0; at < slots_per_pack; at += lanes<P>) {
    P near(Scalar<P>(1));
#pragma GCC unroll 3
    for (const LineOffsets& l : line) {
      near = near * load_marks<P>(interior + at + l.away[1]) *
             load_marks<P>(interior + at + l.away[2]);
    }
    flow = flow && xsimd::all(near > half || load_marks<P>(interior + at) < half);
  }
  return flow;
}

/// Whether velocities are damped by sixth differences, (RP.23).
template <int D>
inline constexpr bool damps_by_sixth_differences = D == 3;

/// Whether the particles of a pack have three interior neighbours to each side along each line.
template <class P, int D>
inline bool is_far_inside(const Mark* interior, const LineOffsets (&line)[D],
                          const FarOffsets (&far)[D]) {
  bool inside = true;
  for (int at = 0; at < slots_per_pack; at += lanes<P>) {
    P all = load_marks<P>(interior + at);
#pragma GCC unroll 3
    for (int axis = 0; axis < D; ++axis) {
#pragma GCC unroll 4
      for (const std::int64_t away : line[axis].away)
        all = all * load_marks<P>(interior + at + away);
      all = all * load_marks<P>(interior + at + far[axis].before) *
            load_marks<P>(interior + at + far[axis].after);
    }
    inside = inside && xsimd::all(all > P(Scalar<P>(0.5)));
  }
  return inside;
}

/// Sums over the directions of delta^6/4 of the velocity in a chunk, with the sign that damps.
/// Returns a mask: bit k is set if the particles of pack k are far inside.
template <class P, int D>
unsigned sixth_differences(const Scalar<P>* const* velocity, const Segment<D>& segment,
                           const Mark* interior, const Chunk& chunk,
                           Scalar<P> (*result)[chunk_slots]) {
  LineOffsets line[D];
  FarOffsets far[D];
  for (int axis = 0; axis < D; ++axis) {
    line[axis] = line_offsets<typename P::arch_type>(segment, axis);
    far[axis] = far_offsets<D>(segment, axis);
  }
  unsigned far_inside = 0;
  for (int begin = 0; begin < chunk.count; begin += slots_per_pack) {
    const bool is_inside = is_far_inside<P>(interior + chunk.first + begin, line, far);
    if (is_inside) far_inside |= 1u << begin / slots_per_pack;
    for (int at = begin; at < begin + slots_per_pack; at += lanes<P>) {
      const std::int64_t slot = chunk.first + at;
#pragma GCC unroll 3
      for (int i = 0; i < D; ++i) {
        const Scalar<P>* centre = velocity[i] + slot;
        if (is_inside) {
          sixth_differences_inside<P>(centre, line, far).store_aligned(&result[i][at]);
          continue;
        }
        P sum(Scalar<P>(0));
#pragma GCC unroll 3
        for (int axis = 0; axis < D; ++axis) {
          sum = sum + sixth_difference<P>(centre, interior + slot, line[axis], far[axis]);
        }
        sum.store_aligned(&result[i][at]);
      }
    }
  }
  return far_inside;
}

/// Whether (RP.23) takes the differences of a swept field: not those of shear stress in 3D.
template <class Arch, int D>
constexpr bool takes_differences(int field) {
  for (int i = 0; D == 3 && i < D; ++i) {
    for (int j = i + 1; j < D; ++j) {
      if (field == D + symmetric_index<D>(i, j)) return false;
    }
  }
  return true;
}

/// Sums over the directions of delta^4 of those fields in a chunk, field by field, between interior
/// particles. Other slots get arbitrary finite values. In 3D the first D fields, the velocities,
/// get sixth differences instead.
template <class P, int D, int F>
void swept_differences(const Scalar<P>* const (&field)[F], const Segment<D>& segment,
                       const Mark* interior, const Chunk& chunk,
                       Scalar<P> (&result)[F][chunk_slots]) {
  constexpr int pack = slots_per_pack;
  constexpr int first = damps_by_sixth_differences<D> ? D : 0;
  unsigned far_inside = 0;
  if constexpr (first > 0) {
    far_inside = sixth_differences<P, D>(field, segment, interior, chunk, result);
  }
  LineOffsets line[D];
  for (int axis = 0; axis < D; ++axis) {
    line[axis] = line_offsets<typename P::arch_type>(segment, axis);
  }
  for (int begin = 0; begin < chunk.count; begin += pack) {
    prefetch_ahead<P>(field, chunk.first + begin + line[D - 1].away[3]);
    const bool flow = (far_inside >> begin / pack & 1u) != 0 ||
                      flow_everywhere<P>(interior + chunk.first + begin, line);
    for (int at = begin; at < begin + pack; at += lanes<P>) {
      const std::int64_t slot = chunk.first + at;
      if (flow) {
#pragma GCC unroll 9
        for (int f = first; f < F; ++f) {
          if (!takes_differences<typename P::arch_type, D>(f)) continue;
          fourth_differences_inside<P>(field[f] + slot, line).store_aligned(&result[f][at]);
        }
        continue;
      }
      Fluxes<P> fluxes[D];
#pragma GCC unroll 3
      for (int axis = 0; axis < D; ++axis) {
        fluxes[axis] = fluxes_between<P>(interior + slot, line[axis]);
      }
#pragma GCC unroll 9
      for (int f = first; f < F; ++f) {
        if (!takes_differences<typename P::arch_type, D>(f)) continue;
        fourth_differences(field[f] + slot, line, fluxes).store_aligned(&result[f][at]);
      }
    }
  }
}

/// Which second differences along a line, centred on a slot and on those before and after it,
/// contribute to the force on the slot: 1 or 0.
template <class P>
struct SecondDifferences {
  P before, own, after;

  SecondDifferences(const Mark* interior, const LineOffsets& line) {
    const P pair_before = load_marks<P>(interior) * load_marks<P>(interior + line.away[1]);
    const P pair_after = load_marks<P>(interior) * load_marks<P>(interior + line.away[2]);
    before = pair_before * load_marks<P>(interior + line.away[0]);
    own = pair_before * pair_after;
    after = pair_after * load_marks<P>(interior + line.away[3]);
  }

  /// Half the derivative of the sum of their squares with respect to the value at `centre`.
  P force(const Scalar<P>* centre, const LineOffsets& line) const {
    const P here = load<P>(centre);
    const P last = load<P>(centre + line.away[1]), next = load<P>(centre + line.away[2]);
    const P bend_before = (here - last) + (load<P>(centre + line.away[0]) - last);
    const P bend = (last - here) + (next - here);
    const P bend_after = (here - next) + (load<P>(centre + line.away[3]) - next);
    return fused(before, bend_before, fused_minus(P(Scalar<P>(2)) * own, bend, after * bend_after));
  }
};

/// Whether all second differences contribute to the force on every slot of a pack.
template <class P, int D>
inline bool pull_everywhere(const Mark* interior, const LineOffsets (&line)[D]) {
  bool pull = true;
  for (int at = 0; at < slots_per_pack; at += lanes<P>) {
    P inside(Scalar<P>(1));
#pragma GCC unroll 3
    for (const LineOffsets& l : line) {
      const SecondDifferences<P> differences(interior + at, l);
      inside = inside * differences.before * differences.after;
    }
    pull = pull && xsimd::all(inside > P(Scalar<P>(0.5)));
  }
  return pull;
}

/// Delta xi of (RP.23) of the particles of a chunk; other slots get arbitrary finite values. Which
/// sum a slot gets depends on its pack, not on its register, so that all instruction sets round
/// alike.
template <class P, int D>
void place_differences(const Scalar<P>* const (&drift)[D], const Segment<D>& segment,
                       const Mark* interior, const Chunk& chunk,
                       Scalar<P> (&result)[D][chunk_slots]) {
  constexpr int pack = slots_per_pack;
  LineOffsets line[D];
  for (int axis = 0; axis < D; ++axis) {
    line[axis] = line_offsets<typename P::arch_type>(segment, axis);
  }
  for (int begin = 0; begin < chunk.count; begin += pack) {
    const bool pull = pull_everywhere<P>(interior + chunk.first + begin, line);
    for (int at = begin; at < begin + pack; at += lanes<P>) {
      const std::int64_t slot = chunk.first + at;
      if (pull) {
#pragma GCC unroll 3
        for (int i = 0; i < D; ++i) {
          fourth_differences_inside<P>(drift[i] + slot, line).store_aligned(&result[i][at]);
        }
        continue;
      }
      P sum[D];
#pragma GCC unroll 3
      for (P& s : sum) s = P(Scalar<P>(0));
#pragma GCC unroll 3
      for (const LineOffsets& l : line) {
        const SecondDifferences<P> differences(interior + slot, l);
#pragma GCC unroll 3
        for (int i = 0; i < D; ++i) sum[i] = sum[i] + differences.force(drift[i] + slot, l);
      }
#pragma GCC unroll 3
      for (int i = 0; i < D; ++i) sum[i].store_aligned(&result[i][at]);
    }
  }
}

/// The strain rate that relaxes the stress, or only its mean, at the rate -kappa delta^4 sigma:
/// Hooke's law inverted.
template <class P, int D>
inline void relaxing_strain_rate(const Material<Scalar<P>>& material, Scalar<P> kappa,
                                 bool relaxes_shear, const P (&difference)[symmetric_components<D>],
                                 P (&strain_rate)[symmetric_components<D>]) {
  using T = Scalar<P>;
  const T shear = material.shear_modulus;
  const T lame = material.bulk_modulus - shear * T(2) / T(3);
  P trace = difference[0];
#pragma GCC unroll 3
  for (int i = 1; i < D; ++i) trace = trace + difference[symmetric_index<D>(i, i)];
  const P mean = trace * P(T(1) / T(D));
  const P volumetric = mean * P(-kappa / (T(D) * lame + 2 * shear));
  const P scale(relaxes_shear ? -kappa / (2 * shear) : T(0));
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

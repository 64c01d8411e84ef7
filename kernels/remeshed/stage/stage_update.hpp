#pragma once

#include "kernels/remeshed/stage/bulk_viscosity.hpp"
#include "kernels/remeshed/stage/runge_kutta.hpp"

/// Updates the state of a chunk from its gradients, field by field: the rates of (RP.13) and of
/// (RP.3) or (RP.8), advanced by (RP.21), and the stress of the new state.
namespace pliant::kernels {

/// Largest values of a block so far, lane by lane.
template <class P>
struct StageExtremes {
  P strain_rate2 = P(Scalar<P>(0));
  P deformation2 = P(Scalar<P>(0));  // [h^2]
  P wave_speed2 = P(Scalar<P>(0));
  std::int64_t non_finite = -1;
};

/// The states of the field that `pick` selects from an Evolving.
template <class Arch, class T, int D, class Pick>
inline StageField<T> stage_field(const Stage<T, D>& stage, const Pick& pick) {
  return {pick(stage.current), pick(stage.start), pick(stage.second), pick(stage.third),
          pick(stage.next)};
}

/// d xi/dt = u, also in slots that are not interior: ghosts move too. Only a chunk with interior
/// particles advances its velocities as well.
template <class P, StagePlace place, bool has_particles, int D>
void advance_drifts(const Stage<Scalar<P>, D>& stage, const Chunk& chunk) {
  using Arch = typename P::arch_type;
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
    const DriftField<Scalar<P>> field = {
        stage.current.drift[i], stage.start.drift[i], stage.next.drift[i],
        stage_field<Arch>(stage, [i](const auto& q) { return q.velocity[i]; })};
    for (int at = 0; at < chunk.count; at += lanes<P>) {
      advance_drift<P, place, has_particles>(field, stage.time_step, chunk.first + at);
    }
  }
}

/// du/dt = (v/m) div sigma, and the drag of (RP.23)
template <class P, StagePlace place, int D>
void advance_velocity(const Stage<Scalar<P>, D>& stage, const RungeKutta<P, place>& runge_kutta,
                      const ChunkGradients<Scalar<P>, D>& gradients, const Chunk& chunk) {
  using Arch = typename P::arch_type;
  for (int at = 0; at < chunk.count; at += lanes<P>) {
    const std::int64_t slot = chunk.first + at;
    const P specific_volume = load<P>(stage.current.volume + slot) / load<P>(stage.mass + slot);
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) {
      const auto field = stage_field<Arch>(stage, [i](const auto& q) { return q.velocity[i]; });
      runge_kutta.advance(field, slot,
                          fused(specific_volume, P::load_aligned(&gradients.force[i][at]),
                                P::load_aligned(&gradients.drag[i][at])));
    }
  }
}

/// dv/dt = v div u
template <class P, StagePlace place, int D>
void advance_volume(const Stage<Scalar<P>, D>& stage, const RungeKutta<P, place>& runge_kutta,
                    const ChunkGradients<Scalar<P>, D>& gradients, const Chunk& chunk) {
  using Arch = typename P::arch_type;
  const auto field = stage_field<Arch>(stage, [](const auto& q) { return q.volume; });
  for (int at = 0; at < chunk.count; at += lanes<P>) {
    const std::int64_t slot = chunk.first + at;
    P divergence = P::load_aligned(&gradients.velocity[0][0][at]);
#pragma GCC unroll 3
    for (int i = 1; i < D; ++i) {
      divergence = divergence + P::load_aligned(&gradients.velocity[i][i][at]);
    }
    runge_kutta.advance(field, slot, load<P>(field.current + slot) * divergence);
  }
}

/// dS/dt by (RP.3) or dF/dt by (RP.8).
template <Model model, class P, StagePlace place, int D>
void advance_material(const Stage<Scalar<P>, D>& stage, const RungeKutta<P, place>& runge_kutta,
                      const ChunkGradients<Scalar<P>, D>& gradients, const Chunk& chunk) {
  using Arch = typename P::arch_type;
  using L = Law<model, P, D>;
  for (int at = 0; at < chunk.count; at += lanes<P>) {
    const std::int64_t slot = chunk.first + at;
    P gradient[D][D], carried[L::components], rate[L::components];
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) {
#pragma GCC unroll 3
      for (int j = 0; j < D; ++j) gradient[i][j] = P::load_aligned(&gradients.velocity[i][j][at]);
    }
#pragma GCC unroll 9
    for (int c = 0; c < L::components; ++c) {
      carried[c] = load<P>(stage.current.material[c] + slot);
    }
    L::rate(stage.material, carried, gradient, rate);
#pragma GCC unroll 9
    for (int c = 0; c < L::components; ++c) {
      const auto field = stage_field<Arch>(stage, [c](const auto& q) { return q.material[c]; });
      runge_kutta.advance(field, slot, rate[c]);
    }
  }
}

/// Stress of the new state.
template <Model model, class P, int D>
void stress_of_next(const Stage<Scalar<P>, D>& stage, const Chunk& chunk) {
  using T = Scalar<P>;
  using L = Law<model, P, D>;
  T* stress[L::symmetric];
#pragma GCC unroll 6
  for (int c = 0; c < L::symmetric; ++c) stress[c] = stage.next_stress[c];
  for (int at = 0; at < chunk.count; at += lanes<P>) {
    const std::int64_t slot = chunk.first + at;
    P carried[L::components];
#pragma GCC unroll 9
    for (int c = 0; c < L::components; ++c) carried[c] = load<P>(stage.next.material[c] + slot);
    const P density = load<P>(stage.mass + slot) / load<P>(stage.next.volume + slot);
    store_stress<model, P, D>(stage.material, carried, density,
                              stage.pack_state[slot / slots_per_pack], stage.interior, slot,
                              stress);
  }
}

/// abs(eps)_F^2 from the gradients, which are zero in slots that are not interior.
template <class P, int D>
void strain_rate_of(const ChunkGradients<Scalar<P>, D>& gradients, const Chunk& chunk,
                    StageExtremes<P>& extremes) {
  using T = Scalar<P>;
  for (int at = 0; at < chunk.count; at += lanes<P>) {
    P norm2(T(0));
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) {
      const P diagonal = P::load_aligned(&gradients.velocity[i][i][at]);
      norm2 = fused(diagonal, diagonal, norm2);
#pragma GCC unroll 3
      for (int j = i + 1; j < D; ++j) {
        const P shear = P::load_aligned(&gradients.velocity[i][j][at]) +
                        P::load_aligned(&gradients.velocity[j][i][at]);
        norm2 = fused(P(T(0.5)) * shear, shear, norm2);
      }
    }
    extremes.strain_rate2 = xsimd::max(extremes.strain_rate2, norm2);
  }
}

/// Computes the wave speed of the new state and checks that the state is possible: finite, with v >
/// 0.
template <Model model, class P, int D>
void examine_next(const Stage<Scalar<P>, D>& stage, const Chunk& chunk,
                  StageExtremes<P>& extremes) {
  using T = Scalar<P>;
  using L = Law<model, P, D>;
  const P zero(T(0));
  for (int at = 0; at < chunk.count; at += lanes<P>) {
    const std::int64_t slot = chunk.first + at;
    const auto inside = interior_lanes<P>(stage.interior, slot);
    const P volume = load<P>(stage.next.volume + slot);
    P carried[L::components];
    P sum = volume * zero;  // NaN if any value is infinite or NaN
#pragma GCC unroll 9
    for (int c = 0; c < L::components; ++c) {
      carried[c] = load<P>(stage.next.material[c] + slot);
      sum = fused(carried[c], zero, sum);
    }
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) {
      sum = fused(load<P>(stage.next.drift[i] + slot), zero, sum);
      sum = fused(load<P>(stage.next.velocity[i] + slot), zero, sum);
    }
#pragma GCC unroll 6
    for (int c = 0; c < L::symmetric; ++c) {
      sum = fused(load<P>(stage.next_stress[c] + slot), zero, sum);
    }
    const auto sound = (sum == zero) && (volume > zero);
    if (extremes.non_finite < 0 && xsimd::any(inside && !sound)) {
      extremes.non_finite = slot + first_lane<P>(inside && !sound);
    }
    const P c2 = L::wave_speed2(stage.material, carried, load<P>(stage.mass + slot) / volume);
    extremes.wave_speed2 =
        xsimd::max(extremes.wave_speed2, xsimd::select(inside && sound, c2, zero));
  }
}

/// The whole update of one chunk.
template <Model model, StagePlace place, class P, int D>
void stage_update(const Stage<Scalar<P>, D>& stage, const ChunkGradients<Scalar<P>, D>& gradients,
                  const Chunk& chunk, StageExtremes<P>& extremes) {
  const RungeKutta<P, place> runge_kutta(stage.time_step);
  const bool relaxes = model == Model::reduced_polynomial && stage.viscosity.terms > 0;
  if (relaxes && stage.stage == 0) keep_volume_changes<P, D>(stage, chunk);
  advance_drifts<P, place, true>(stage, chunk);
  advance_velocity(stage, runge_kutta, gradients, chunk);
  advance_volume(stage, runge_kutta, gradients, chunk);
  advance_material<model>(stage, runge_kutta, gradients, chunk);
  stress_of_next<model, P>(stage, chunk);
  constexpr bool is_last = place == StagePlace::last;
  if (relaxes) relax_next<is_last, P, D>(stage, chunk);
  if constexpr (is_last) {
    strain_rate_of(gradients, chunk, extremes);
    examine_next<model>(stage, chunk, extremes);
  }
}

}  // namespace pliant::kernels

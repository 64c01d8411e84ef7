#pragma once

#include "kernels/remeshed/stage/bspline.hpp"
#include "kernels/remeshed/stage/stage_gradients.hpp"

/// Plain SPH over neighbour lists: the velocity gradient (RP.25) and the acceleration (RP.26).
namespace pliant::kernels {

/// The particles p of a register and their sums over neighbours.
template <class P, int D>
class PairForces {
  using T = Scalar<P>;
  static constexpr int symmetric = symmetric_components<D>;

 public:
  PairForces(const Stage<T, D>& stage, std::int64_t slot)
      : stage_(stage), pairs_(*stage.pairs), omega_(stage.spacing) {
    const T h = stage.spacing;
    T scale = bspline_normalisation<D>;
    for (int i = 0; i < D + 2; ++i) scale /= h;
    slope_ = scale;
    per_w_ = T(1) / bspline(P(T(1))).get(0);
    take(own_state_, [&](const T* field) { return load<P>(field + slot); });
    for (int i = 0; i < D; ++i) {
      acceleration[i] = P(T(0));
      for (int j = 0; j < D; ++j) gradient[i][j] = P(T(0));
    }
  }

  /// Adds neighbours `offset` cells away; `neighbour(field)` loads their values.
  template <class Load>
  [[gnu::always_inline]] void meet(const P (&offset)[D], const Load& neighbour) {
    Particle q;
    take(q, neighbour);
    P d[D], difference[D];
    P distance2(T(0)), approach(T(0));
    for (int i = 0; i < D; ++i) {
      d[i] = q.drift[i] - fused_minus(offset[i], P(stage_.spacing), own_state_.drift[i]);
      difference[i] = q.velocity[i] - own_state_.velocity[i];
      distance2 = fused(d[i], d[i], distance2);
      approach = fused(d[i], difference[i], approach);
    }
    const P slope = omega_(distance2) * slope_;
    const P viscous = viscosity(q.density, distance2, approach);
    const P w = bspline(xsimd::sqrt(distance2) * P(1 / stage_.spacing)) * per_w_;
    const P share = (w * w) * (w * w);
    const P volume_slope = q.mass / q.density * slope, mass_slope = q.mass * slope;
    for (int i = 0; i < D; ++i) {
      P pull = -viscous * d[i];
      for (int j = 0; j < D; ++j) {
        const int c = symmetric_index<D>(i, j);
        const P stress = fused(share, own_state_.artificial[c] + q.artificial[c],
                               own_state_.stress[c] + q.stress[c]);
        pull = fused(stress, d[j], pull);
        gradient[i][j] = fused(volume_slope * difference[i], d[j], gradient[i][j]);
      }
      acceleration[i] = fused(mass_slope, pull, acceleration[i]);
    }
  }

  P gradient[D][D], acceleration[D];

 private:
  struct Particle {
    P drift[D], velocity[D], stress[symmetric], artificial[symmetric], mass, density;
  };

  template <class Load>
  [[gnu::always_inline]] void take(Particle& particle, const Load& load_field) const {
    for (int i = 0; i < D; ++i) {
      particle.drift[i] = load_field(stage_.current.drift[i]);
      particle.velocity[i] = load_field(stage_.current.velocity[i]);
    }
    for (int c = 0; c < symmetric; ++c) {
      particle.stress[c] = load_field(pairs_.stress[c]);
      particle.artificial[c] = load_field(pairs_.artificial[c]);
    }
    particle.mass = load_field(stage_.mass);
    particle.density = particle.mass / load_field(stage_.current.volume);
  }

  // Pi of (RP.27).
  [[gnu::always_inline]] P viscosity(const P& density, const P& distance2,
                                     const P& approach) const {
    const T h = stage_.spacing;
    const P mu = P(h) * approach / (distance2 + P(T(0.01) * h * h));
    const P mean = P(T(0.5)) * (density + own_state_.density);
    const P pi = mu * fused(P(pairs_.quadratic), mu, P(-pairs_.linear)) / mean;
    return xsimd::select(approach < P(T(0)), pi, P(T(0)));
  }

  const Stage<T, D>& stage_;
  const SymmetricPairs<T, D>& pairs_;
  PairWeight<Kernel::quartic_spline, P> omega_;
  P slope_, per_w_;
  Particle own_state_;
};

/// Gradients of a chunk over neighbour lists: grad u, and the whole acceleration as a drag.
template <class P, int D>
void symmetric_gradients(const Stage<Scalar<P>, D>& stage, const Segment<D>&, const Chunk& chunk,
                         ChunkGradients<Scalar<P>, D>& gradients) {
  using T = Scalar<P>;
  constexpr int pack = slots_per_pack;
  const NeighbourLists<D>& lists = *stage.neighbours;
  for (int at = 0; at < chunk.count; at += lanes<P>) {
    const std::int64_t slot = chunk.first + at;
    const PackState state = stage.pack_state[slot / pack];
    PairForces<P, D> forces(stage, slot);
    visit_list<P, D>(lists, slot, [&](const P(&offset)[D], const auto& neighbour) {
      forces.meet(offset, neighbour);
    });
    StageGradients<P, D> result;
    for (int i = 0; i < D; ++i) {
      result.force[i] = P(T(0));
      result.drag[i] = forces.acceleration[i];
      for (int j = 0; j < D; ++j) result.velocity[i][j] = forces.gradient[i][j];
    }
    store_gradients<P, D>(result, state, stage.interior, slot, at, gradients);
  }
}

}  // namespace pliant::kernels

#pragma once

#include "kernels/total_lagrangian/fitted_cells.hpp"
#include "kernels/total_lagrangian/regular_cells.hpp"

namespace pliant::kernels {

/// Adds the lanes of a register to a sum, in order.
template <class P>
inline void add_lanes(const P& pack, double& sum) {
  alignas(64) Scalar<P> lane[lanes<P>];
  pack.store_aligned(lane);
  for (int l = 0; l < lanes<P>; ++l) sum += lane[l];
}

/// Moves the particles of a block, from its first slot on, as their forces become known, (TL.8).
/// Sums are over eight lanes for any register, so that they are the same for all instruction sets
/// with fused multiply-add.
template <class P, int D>
class Mover {
 public:
  using T = Scalar<P>;

  explicit Mover(const Motion<T, D>& block) : block_(block) {
#pragma GCC unroll 4
    for (int k = 0; k < registers; ++k) inertia_[k] = damped_[k] = P(T(0));
  }

  /// Moves particles up to the slot at offset `end` from the first.
  void move_until(std::int64_t end) {
    const P zero(T(0));
    for (; moved_ < end; moved_ += lanes<P>) {
      const std::int64_t slot = block_.first_slot + moved_;
      const P inverse_mass = load<P>(block_.inverse_mass + slot);
      const auto inside = inverse_mass > zero;
      if (xsimd::any(inside)) move(slot, inverse_mass, inside);
    }
  }

  void add_to(MotionResult& result) const {
#pragma GCC unroll 4
    for (int k = 0; k < registers; ++k) {
      add_lanes(inertia_[k], result.inertia);
      add_lanes(damped_[k], result.damped);
    }
  }

 private:
  static constexpr int registers = registers_per_pack<P>;

  void move(std::int64_t slot, const P& inverse_mass, const typename P::batch_bool_type& inside) {
    const P zero(T(0));
    const int k = static_cast<int>(moved_ % slots_per_pack) / lanes<P>;
    const P mass = block_.damped ? xsimd::select(inside, P(T(1)) / inverse_mass, zero) : zero;
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) {
      T* const sum = block_.force[i] + moved_;
      const P force = xsimd::select(inside, load<P>(sum), zero);
      zero.store_unaligned(sum);
      const P u = load<P>(block_.velocity[i] + slot);
      force.store_unaligned(block_.internal[i] + slot);
      const T* const traction = block_.traction[i];
      const P pull = traction == nullptr ? force : force + load<P>(traction + slot);
      const P next = fused(P(block_.gained) * inverse_mass, pull, P(block_.kept) * u);
      if (block_.damped) {
        const P mean = P(T(0.5)) * (u + next);
        inertia_[k] = fused(u * u, mass, inertia_[k]);
        damped_[k] = fused(mean * mean, mass, damped_[k]);
      }
      next.store_unaligned(block_.velocity[i] + slot);
      fused(P(block_.time_step), next, load<P>(block_.displacement[i] + slot))
          .store_unaligned(block_.next_displacement[i] + slot);
    }
  }

  const Motion<T, D>& block_;
  std::int64_t moved_ = 0;
  P inertia_[registers], damped_[registers];
};

/// A particle moves as soon as the cells around it are done, while its data are in the cache. None
/// of these cells has a higher slot.
template <ElasticLaw law, bool relaxes, class P, int D>
MotionResult advance_motion_of(const Motion<Scalar<P>, D>& block) {
  StressPointExtremes<P> extremes;
  evaluate_fitted_cells<law, relaxes, P, D>(block, extremes);
  Mover<P, D> mover(block);
  UpperCorners<P, D> upper;
  upper.clear();
  for (int k = 0; k < block.run_count; ++k) {
    const CellRun<D>& run = block.runs[k];
    if (run.cut) {
      evaluate_run<law, relaxes, true, P, D>(block, run, upper, extremes);
    } else {
      evaluate_run<law, relaxes, false, P, D>(block, run, upper, extremes);
    }
    if (run.own) mover.move_until(run.first + run.count - block.first_slot);
  }
  mover.move_until(block.slot_count);
  MotionResult result;
  result.wave_speed = square_root<P>(largest(extremes.wave_speed2));
  result.non_finite = extremes.non_finite;
  mover.add_to(result);
  return result;
}

/// See Motion. Laws without networks have their own loops.
template <class P, int D>
MotionResult advance_motion(const Motion<Scalar<P>, D>& block) {
  using enum ElasticLaw;
  switch (block.material.law) {
    case neo_hookean:
      return advance_motion_of<neo_hookean, false, P, D>(block);
    case st_venant_kirchhoff:
      return advance_motion_of<st_venant_kirchhoff, false, P, D>(block);
    case reduced_polynomial:
      break;
  }
  return block.networks.terms > 0 ? advance_motion_of<reduced_polynomial, true, P, D>(block)
                                  : advance_motion_of<reduced_polynomial, false, P, D>(block);
}

}  // namespace pliant::kernels

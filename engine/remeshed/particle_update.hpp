#pragma once

#include <array>
#include <vector>

#include "engine/method/resources.hpp"
#include "engine/remeshed/loads/body_forces.hpp"
#include "engine/remeshed/state/state.hpp"
#include "kernels/remeshed/table.hpp"

namespace pliant::remeshed {

/// What ParticleUpdate::advance writes, and what it reads only of its own block.
Accesses read_by_update(int stage);
Accesses written_by_update(int stage);
/// The same for ParticleUpdate::evaluate_stress, which also sets slots that no stage advances to
/// rest, in all copies.
Accesses read_by_evaluate_stress();
Accesses written_by_evaluate_stress();

/// The part of a stage that advances the particles of a block, when ghosts and images are up to
/// date.
template <class T, int D>
class ParticleUpdate {
 public:
  ParticleUpdate(State<T, D>& state, const Case& settings,
                 const kernels::RemeshedTable<T, D>& kernels);

  /// Fixes the time step [s].
  void prepare(double time_step);

  /// Computes the rates (RP.13) by (RP.20), or by (RP.25) and (RP.26), the next stage state (RP.21)
  /// and its stress. With `pairs`, the sums are those of plain SPH over neighbour lists.
  kernels::StageResult advance(int block, int stage,
                               const kernels::SymmetricPairs<T, D>* pairs = nullptr);
  /// Adds the work of body forces in the step to the energy budget of the state.
  void fold() { body_forces_.fold(); }
  /// The body force at a stage.
  BodyForce<D> body_force(int stage) const { return body_forces_.at(stage); }
  /// [block] impulse of body forces in the step [N s].
  const std::vector<Point<D>>& body_force_impulse() const { return body_forces_.impulse(); }
  /// [block][stage] body forces in the step.
  const std::vector<std::array<ForceOnBlock<D>, 4>>& body_forces() const {
    return body_forces_.forces();
  }
  /// Evaluates the stress of a state that no stage has written.
  kernels::StageResult evaluate_stress(int block);

 private:
  /// Everything that a stage needs except the neighbours.
  kernels::Stage<T, D> stage_of(Body<T, D>& body, int block, int stage) const;

  State<T, D>& state_;
  const Case& settings_;
  const kernels::RemeshedTable<T, D>& kernels_;
  BodyForces<T, D> body_forces_;
  double time_step_ = 0;
  std::array<std::vector<std::vector<kernels::Relaxation<T>>>, 4> relaxation_;  ///< [stage][body]
};

extern template class ParticleUpdate<double, 2>;
extern template class ParticleUpdate<double, 3>;
extern template class ParticleUpdate<float, 2>;
extern template class ParticleUpdate<float, 3>;

}  // namespace pliant::remeshed

#pragma once

#include <array>
#include <vector>

#include "engine/method/resources.hpp"
#include "engine/remeshed/loads/body_forces.hpp"
#include "engine/remeshed/state/state.hpp"
#include "kernels/remeshed/table.hpp"

namespace pliant::remeshed {

/// What ParticleUpdate::advance reads of its own block besides the values that neighbours have too,
/// and what it writes.
Accesses read_by_update(int stage);
Accesses written_by_update(int stage);
/// The same of ParticleUpdate::evaluate_stress, which also puts slots that no stage advances at
/// rest in all copies.
Accesses read_by_evaluate_stress();
Accesses written_by_evaluate_stress();

/// What a stage does to the particles of a block, once ghosts and images are there.
template <class T, int D>
class ParticleUpdate {
 public:
  ParticleUpdate(State<T, D>& state, const Case& settings,
                 const kernels::RemeshedTable<T, D>& kernels);

  /// Fixes the time step [s].
  void prepare(double time_step);

  /// Rates (RP.13) by (RP.20), or by (RP.25) and (RP.26), the next stage state (RP.21) and its
  /// stress.
  /// With `pairs`, the sums of plain SPH over lists of neighbours.
  kernels::StageResult advance(int block, int stage,
                               const kernels::SymmetricPairs<T, D>* pairs = nullptr);
  /// Adds the work of body forces in the step to the state.
  void fold() { body_forces_.fold(); }
  /// What acts on the material of a block at a stage.
  BodyForce<D> body_force(int block, int stage) const { return body_forces_.of(block, stage); }
  /// [block] impulse of body forces in the step [N s].
  const std::vector<Point<D>>& body_force_impulse() const { return body_forces_.impulse(); }
  /// [block][stage] body forces in the step.
  const std::vector<std::array<ForceOnBlock<D>, 4>>& body_forces() const {
    return body_forces_.forces();
  }
  /// Stress of a state that no stage has left behind.
  kernels::StageResult evaluate_stress(int block);

 private:
  /// Everything of a stage but its neighbours.
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

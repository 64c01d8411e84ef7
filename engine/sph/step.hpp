#pragma once

#include <vector>

#include "engine/remeshed/particle_update.hpp"
#include "engine/remeshed/state/stage_results.hpp"
#include "engine/remeshed/state/state.hpp"
#include "engine/sph/pair_stress.hpp"
#include "kernels/remeshed/table.hpp"
#include "scheduler/phase.hpp"

namespace pliant::sph {

/// One step of plain SPH as phases: four Runge-Kutta stages over neighbour lists.
template <class T, int D>
class Step {
 public:
  Step(remeshed::State<T, D>& state, const Case& settings,
       const kernels::RemeshedTable<T, D>& kernels);

  /// Makes room for the present blocks and slots of the state.
  void use_slots();
  /// The phases of a step over the present blocks.
  std::vector<scheduler::Phase> phases();
  /// The phases that compute the stress of the initial state.
  std::vector<scheduler::Phase> stress_phases();

  /// Sets the time step [s].
  void prepare(double time_step) { particles_.prepare(time_step); }
  /// Sums the results of the blocks in their order.
  void fold() {
    results_.fold(state_.blocks);
    particles_.fold();
  }
  const remeshed::StageResults& results() const { return results_; }
  std::size_t bytes() const;

 private:
  void find_stress_of_pairs(int block, int stage);
  void advance(int block, int stage);

  remeshed::State<T, D>& state_;
  const Case& settings_;
  remeshed::ParticleUpdate<T, D> particles_;
  std::vector<PairStress<T, D>> pair_stress_;  ///< [body]
  remeshed::StageResults results_;
};

extern template class Step<double, 2>;
extern template class Step<double, 3>;
extern template class Step<float, 2>;
extern template class Step<float, 3>;

}  // namespace pliant::sph

#include "engine/remeshed/particle_update.hpp"

#include <cmath>

#include "engine/remeshed/ghosts/lasting_correction.hpp"
#include "engine/remeshed/parameters.hpp"
#include "engine/remeshed/runge_kutta.hpp"
#include "engine/remeshed/setup/particle_kinds.hpp"
#include "engine/remeshed/state/resources.hpp"
#include "kernels/remeshed/stage/relaxation.hpp"

namespace pliant::remeshed {

using namespace resource;

namespace {

/// One copy of the state without the drift, Q of (RP.21), in all slots.
Resources state(int copy) { return slots(Group::velocity, copy) + slots(Group::material, copy); }

/// r of (RP.23) [c/h]. Loads that last let a zigzag of positions grow, which the force holds down
/// (docs/decisions/0092-places-under-lasting-loads.md, 0093-solids-under-lasting-loads.md); bodies
/// that swing freely lose energy by it.
template <class T, int D>
double restoring_share(const Body<T, D>& body) {
  if (body.bears_loads) return 0.3;
  return D == 2 ? 0.1 : 0;
}

/// Sets v = h^d on ghosts, as after a remeshing; needed where a gradient reads it.
template <class T, int D>
void set_ghost_volumes(Body<T, D>& body, int block) {
  const T volume = static_cast<T>(std::pow(body.lattice.spacing, D));
  T* v = body.stage[0].get(Field::volume);
  for (const std::int32_t slot : body.population.ghosts[block].slot) v[slot] = volume;
}

}  // namespace

// Stage 2 reads Q2 for (Q2 - Q0)/3; stage 3 reads Q3 for (Q4 - Q3)/3.
Accesses read_by_update(int stage) {
  const Accesses reads = own(state(0) + state(buffer_of(stage)) + slots(Group::drift, 0) +
                             slots(Group::drift, drift_buffer_of(stage)) + slots(Group::constants) +
                             slots(Group::memory) + whole(Group::kinds) + whole(Group::interior) +
                             whole(Group::neighbour_lists));
  return stage < 2 ? reads : reads + own(state(stage - 1));
}

// Stage 2 overwrites Q0 with Q3 + (Q2 - Q0)/3. The first stage keeps J - 1; the last one writes the
// new pressures p_i, (RP.22).
Accesses written_by_update(int stage) {
  Accesses writes =
      own(state(buffer_after(stage)) + slots(Group::drift, drift_buffer_after(stage)) +
          slots(Group::stress, 1 - stage % 2) + whole(Group::results));
  if (stage == 2) writes = writes + own(state(0));
  if (stage == 0 || stage == 3) writes = writes + own(slots(Group::memory));
  return writes;
}

Accesses read_by_evaluate_stress() {
  return own(slots(Group::material) + slots(Group::constants) + slots(Group::memory) +
             whole(Group::kinds));
}

Accesses written_by_evaluate_stress() {
  return own(slots(Group::stress, 0) + slots(Group::stress, 1) + slots(Group::drift, 1) +
             slots(Group::velocity, 1) + slots(Group::velocity, 2) + ghosts(Group::material) +
             whole(Group::interior) + whole(Group::results));
}

template <class T, int D>
ParticleUpdate<T, D>::ParticleUpdate(State<T, D>& state, const Case& settings,
                                     const kernels::RemeshedTable<T, D>& kernels)
    : state_(state), settings_(settings), kernels_(kernels), body_forces_(state, settings) {}

// Relaxation (RP.22), for the time of the state that each stage writes.
template <class T, int D>
void ParticleUpdate<T, D>::prepare(double time_step) {
  time_step_ = time_step;
  body_forces_.prepare(time_step);
  for (int stage = 0; stage < 4; ++stage) {
    relaxation_[stage].resize(state_.bodies.size());
    for (std::size_t b = 0; b < state_.bodies.size(); ++b) {
      const Body<T, D>& body = state_.bodies[b];
      auto& terms = relaxation_[stage][b];
      terms.resize(body.prony.size());
      for (std::size_t i = 0; i < terms.size(); ++i) {
        terms[i] = kernels::relaxation<T>(body.prony[i], body.material.bulk_modulus,
                                          stage_end[stage] * time_step);
      }
    }
  }
}

template <class T, int D>
kernels::Stage<T, D> ParticleUpdate<T, D>::stage_of(Body<T, D>& body, int block, int stage) const {
  const Population<T, D>& population = body.population;
  const Block<D>& range = population.layout.blocks()[block];
  kernels::Stage<T, D> work = {};
  work.segments = population.layout.segments_of(range);
  work.segment_count = range.segment_count;
  work.spacing = static_cast<T>(body.lattice.spacing);
  work.time_step = static_cast<T>(time_step_);
  // The wave speed is that at rest: a present one would be one step late, or that of another body.
  const DissipationCase& dissipation = settings_.discretisation.dissipation;
  const T crossing = kernels::wave_speed_at_rest(body.material) / work.spacing;
  const T rate = crossing / 16;
  work.velocity_dissipation = static_cast<T>(dissipation.velocity) * rate;
  work.restoring_rate = static_cast<T>(restoring_share(body)) * crossing;
  work.stress_dissipation = static_cast<T>(dissipation.stress) * rate;
  work.relaxes_shear = relaxes_shear(body);
  work.stage = stage;
  work.kernel = settings_.discretisation.kernel;
  work.gradient = parameters_of(settings_).gradient;
  work.material = body.material;
  work.pack_state = population.pack_state.get();
  work.interior = body.interior.get();
  work.mass = body.stage[0].get(Field::mass);
  work.current = body.template evolving<const T>(stage);
  work.stress = std::as_const(body).stress_view(stage % 2);
  work.start = body.stage[0].evolving();
  work.second = body.stage[1].template evolving<const T>();
  work.third = body.stage[2].template evolving<const T>();
  work.next = body.evolving((stage + 1) % 4);
  work.next_stress = body.stress_view(1 - stage % 2);
  return work;
}

template <class T, int D>
kernels::StageResult ParticleUpdate<T, D>::advance(int block, int stage,
                                                   const kernels::SymmetricPairs<T, D>* pairs) {
  const auto [body, local] = state_.owner(block);
  kernels::Stage<T, D> work = stage_of(body, local, stage);
  work.viscosity = body.viscosity(relaxation_[stage][state_.blocks[block].body].data());
  kernels::NeighbourLists<D> lists;
  if (body.neighbours.are_listed && body.neighbours.blocks[local].are_listed) {
    lists = body.neighbours.lists(local);
    work.neighbours = &lists;
  }
  work.pairs = pairs;
  const kernels::StageResult result = kernels_.advance_stage(work);
  body_forces_.advance(block, stage);
  return result;
}

template <class T, int D>
kernels::StageResult ParticleUpdate<T, D>::evaluate_stress(int block) {
  const auto [body, local] = state_.owner(block);
  const Block<D>& range = body.population.layout.blocks()[local];
  kernels::StressOfState<T, D> work = {};
  work.segments = body.population.layout.segments_of(range);
  work.segment_count = range.segment_count;
  work.material = body.material;
  work.pack_state = body.population.pack_state.get();
  work.interior = body.interior.get();
  work.mass = body.stage[0].get(Field::mass);
  work.state = body.stage[0].template evolving<const T>();
  work.stress = body.stress_view(0);
  prepare_slots(body, local);
  if (reads_volumes(settings_)) set_ghost_volumes(body, local);
  work.viscosity = body.viscosity();
  return kernels_.evaluate_stress(work);
}

template class ParticleUpdate<double, 2>;
template class ParticleUpdate<double, 3>;
template class ParticleUpdate<float, 2>;
template class ParticleUpdate<float, 3>;

}  // namespace pliant::remeshed

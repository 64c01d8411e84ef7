#include "engine/remeshed/particle_update.hpp"

#include "engine/remeshed/ghosts/ghost_fits.hpp"
#include "engine/remeshed/pair_stress.hpp"
#include "engine/remeshed/runge_kutta.hpp"
#include "kernels/remeshed/stage/relaxation.hpp"

namespace pliant::remeshed {

template <class T, int D>
ParticleUpdate<T, D>::ParticleUpdate(State<T, D>& state, const Case& settings,
                                     const kernels::RemeshedTable<T, D>& kernels)
    : state_(state), settings_(settings), kernels_(kernels) {}

// (RP.71), to the time of the state that each stage leaves behind.
template <class T, int D>
void ParticleUpdate<T, D>::prepare(double time_step) {
  time_step_ = time_step;
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
  // At rest: a speed that followed the state would be one step late, or another body's.
  work.dissipation = static_cast<T>(settings_.discretisation.dissipation) *
                     kernels::wave_speed_at_rest(body.material) / (16 * work.spacing);
  work.stage = stage;
  work.weight = settings_.discretisation.kernel;
  work.material = body.material;
  work.pack_state = population.pack_state.get();
  work.interior = body.interior.get();
  work.mass = body.stage[0].get(Field::mass);
  work.current = body.stage[buffer_of(stage)].template evolving<const T>();
  work.stress = std::as_const(body).stress_view(stage % 2);
  work.start = body.stage[0].evolving();
  work.second = body.stage[1].template evolving<const T>();
  work.third = body.stage[2].template evolving<const T>();
  work.next = body.stage[buffer_after(stage)].evolving();
  work.next_stress = body.stress_view(1 - stage % 2);
  return work;
}

template <class T, int D>
kernels::StageResult ParticleUpdate<T, D>::advance(int block, int stage) {
  const auto [body, local] = state_.owner(block);
  kernels::Stage<T, D> work = stage_of(body, local, stage);
  work.viscosity = body.viscosity(relaxation_[stage][state_.blocks[block].body].data());
  kernels::NeighbourLists<D> lists;
  if (body.neighbours.are_listed && body.neighbours.blocks[local].are_listed) {
    lists = body.neighbours.lists(local);
    work.neighbours = &lists;
  }
  kernels::SymmetricPairs<T, D> pairs;
  if (body.is_plain_sph) {
    pairs = symmetric_pairs<T, D>(body, settings_.discretisation.artificial_viscosity);
    work.pairs = &pairs;
  }
  return kernels_.advance_stage(work);
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
  work.viscosity = body.viscosity();
  return kernels_.evaluate_stress(work);
}

template class ParticleUpdate<double, 2>;
template class ParticleUpdate<double, 3>;
template class ParticleUpdate<float, 2>;
template class ParticleUpdate<float, 3>;

}  // namespace pliant::remeshed

#include "engine/sph/step.hpp"

#include "engine/method/phase_rows.hpp"
#include "engine/remeshed/state/resources.hpp"
#include "engine/sph/parameters.hpp"

// A step of plain SPH, the baseline of H&K. Each of the four stages of the Runge-Kutta method
// (RP.21) has two phases:
//
//     pair stress       sigma/rho^2 of every particle, and its artificial stress (RP.28)
//     advance           grad u by (RP.25) and the pair forces (RP.26), (RP.27) over neighbour
//                       lists, the rates (RP.13), the next state and its stress (RP.3)-(RP.9)
//
// There are no ghosts: particles at a free surface have fewer neighbours. New lists are made before
// every step, in solver.cpp; they may contain particles of any block.
namespace pliant::sph {

using scheduler::Phase;
using namespace remeshed::resource;
using enum remeshed::Group;

template <class T, int D>
Step<T, D>::Step(remeshed::State<T, D>& state, const Case& settings,
                 const kernels::RemeshedTable<T, D>& kernels)
    : state_(state), settings_(settings), particles_(state, settings, kernels) {}

template <class T, int D>
void Step<T, D>::use_slots() {
  results_.reset(state_.blocks, state_.bodies.size());
  pair_stress_.resize(state_.bodies.size());
  for (std::size_t b = 0; b < state_.bodies.size(); ++b) {
    pair_stress_[b].grow(state_.bodies[b].population.layout.slots());
  }
}

template <class T, int D>
std::vector<Phase> Step<T, D>::phases() {
  std::vector<Phase> phases;
  for (int stage = 0; stage < 4; ++stage) {
    const int current = remeshed::buffer_of(stage);
    PhaseRows rows = PhaseRows(phases).at_stage(stage);
    rows.each("pair stress",
              own(particles(stress, stage % 2) + particles(material, current) +
                  particles(constants) + whole(kinds)),
              own(whole(pair_stress)),
              [this, stage](int block) { find_stress_of_pairs(block, stage); });
    rows.each(
        "advance",
        all(particles(drift, remeshed::drift_buffer_of(stage)) + particles(velocity, current) +
            particles(material, current) + particles(constants) + whole(pair_stress)) +
            remeshed::read_by_update(stage),
        remeshed::written_by_update(stage), [this, stage](int block) { advance(block, stage); });
  }
  return phases;
}

template <class T, int D>
std::vector<Phase> Step<T, D>::stress_phases() {
  std::vector<Phase> phases;
  PhaseRows(phases).each(
      "stress", remeshed::read_by_evaluate_stress(), remeshed::written_by_evaluate_stress(),
      [this](int block) { results_[block] = particles_.evaluate_stress(block); });
  return phases;
}

template <class T, int D>
void Step<T, D>::find_stress_of_pairs(int block, int stage) {
  const BlockOwner owner = state_.blocks[block];
  find_pair_stress<T, D>(state_.bodies[owner.body], owner.block, stage,
                         parameters_of(settings_).artificial_stress, pair_stress_[owner.body]);
}

template <class T, int D>
void Step<T, D>::advance(int block, int stage) {
  const int body = state_.blocks[block].body;
  const kernels::SymmetricPairs<T, D> pairs = symmetric_pairs<T, D>(
      state_.bodies[body], pair_stress_[body], parameters_of(settings_).artificial_viscosity);
  results_[block] = particles_.advance(block, stage, &pairs);
}

template <class T, int D>
std::size_t Step<T, D>::bytes() const {
  std::size_t sum = 0;
  for (const PairStress<T, D>& of_body : pair_stress_) sum += of_body.bytes();
  return sum;
}

template class Step<double, 2>;
template class Step<double, 3>;
template class Step<float, 2>;
template class Step<float, 3>;

}  // namespace pliant::sph

#include "engine/sph/step.hpp"

#include <algorithm>

#include "engine/remeshed/resources.hpp"

// A step of plain SPH, the baseline of H&K.
//
//   for each stage s = 0..3 of the Runge-Kutta method (RP.19), stage states Q0, Q2, Q3, Q4 (where
//   Q2 was):
//     pair stress   sigma/rho^2 of every particle, and its artificial stress (RP.76)
//     advance       grad u by (RP.73) and the forces of the pairs (RP.74), (RP.75) over listed
//                   neighbours, the rates (RP.12), the next stage state and the stress that belongs
//                   to it (RP.3)-(RP.9)
//
// There are no ghosts: particles at a free surface simply have fewer neighbours. The lists are made
// anew before every step, in solver.cpp, and may name particles of any block.
namespace pliant::sph {

namespace resource = remeshed::resource;
using scheduler::Phase;
using scheduler::Reach;

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
    const int parity = stage % 2;
    const int current = remeshed::buffer_of(stage), next = remeshed::buffer_after(stage);
    phases.push_back({.name = "pair stress",
                      .stage = stage,
                      .reads = {{resource::stress(parity)}, {resource::material(current)}},
                      .writes = {{resource::pair_stress}},
                      .run = [this, stage](int block) { find_stress_of_pairs(block, stage); }});
    Phase advancing = {.name = "advance",
                       .stage = stage,
                       .reads = {{resource::drift(current), Reach::all},
                                 {resource::velocity(current), Reach::all},
                                 {resource::material(current), Reach::all},
                                 {resource::pair_stress, Reach::all}},
                       .writes = {{resource::stress(1 - parity)}, {resource::result}},
                       .run = [this, stage](int block) { advance(block, stage); }};
    for (int buffer = 0; buffer <= std::min(stage, 2); ++buffer) {
      advancing.reads.insert(
          advancing.reads.end(),
          {{resource::drift(buffer)}, {resource::velocity(buffer)}, {resource::material(buffer)}});
    }
    const auto write_state = [&](int buffer) {
      advancing.writes.insert(
          advancing.writes.end(),
          {{resource::drift(buffer)}, {resource::velocity(buffer)}, {resource::material(buffer)}});
    };
    write_state(next);
    if (stage == 2) write_state(0);
    phases.push_back(std::move(advancing));
  }
  return phases;
}

template <class T, int D>
std::vector<Phase> Step<T, D>::stress_phases() {
  return {{.name = "stress",
           .reads = {{resource::material(0)}},
           .writes = {{resource::stress(0)}},
           .run = [this](int block) { results_[block] = particles_.evaluate_stress(block); }}};
}

template <class T, int D>
void Step<T, D>::find_stress_of_pairs(int block, int stage) {
  const BlockOwner owner = state_.blocks[block];
  find_pair_stress<T, D>(state_.bodies[owner.body], owner.block, stage,
                         settings_.sph.artificial_stress, pair_stress_[owner.body]);
}

template <class T, int D>
void Step<T, D>::advance(int block, int stage) {
  const int body = state_.blocks[block].body;
  const kernels::SymmetricPairs<T, D> pairs = symmetric_pairs<T, D>(
      state_.bodies[body], pair_stress_[body], settings_.sph.artificial_viscosity);
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

}  // namespace pliant::sph

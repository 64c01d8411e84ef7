#include "engine/finite_elements/solver.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/case/stability.hpp"
#include "engine/finite_elements/measure.hpp"
#include "engine/finite_elements/parameters.hpp"
#include "engine/finite_elements/setup.hpp"
#include "engine/method/step_failure.hpp"
#include "engine/point_based/observe/field_views.hpp"
#include "engine/point_based/observe/frame.hpp"
#include "engine/point_based/state_archive.hpp"

namespace pliant::finite_elements {

namespace {

constexpr int examine_every = 8;  // steps

/// Nodes move as those of the point-based method, by the keys of this one.
Case with_keys_of_nodes(Case a_case) {
  const Parameters given = parameters_of(a_case);
  auto& of_nodes = a_case.parameters.as<point_based::Parameters>();
  of_nodes = {};
  of_nodes.integrator = given.integrator;
  of_nodes.damping = given.damping;
  return a_case;
}

bool is_leapfrog(const Case& settings) {
  return parameters_of(settings).integrator == point_based::Integrator::leapfrog;
}

}  // namespace

template <class T, int D>
Solver<T, D>::Solver(const Case& a_case, const SolverOptions& options)
    : Base(with_keys_of_nodes(a_case), options),
      state_(this->settings().boundaries),
      step_(state_, this->settings(), options.isa) {
  state_.bodies.resize(this->settings().bodies.size());
  state_.elements.resize(state_.bodies.size());
  std::vector<scheduler::Blocks> blocks;
  blocks.reserve(state_.bodies.size());
  for (std::size_t b = 0; b < state_.bodies.size(); ++b) {
    const BodyCase& source = this->settings().bodies[b];
    point_based::Body<T, D>& body = state_.bodies[b];
    make_body(this->settings(), source, state_.boundaries, body, state_.elements[b]);
    blocks.push_back(body.adjacency);
    number_blocks(static_cast<int>(b), body.adjacency.count(), state_.blocks);
    highest_frequency_ = std::max(highest_frequency_, state_.elements[b].highest_frequency);
    state_.clock.wave_speed =
        std::max(state_.clock.wave_speed, kernels::wave_speed_at_rest(source.material));
  }
  state_.clock.damping = parameters_of(this->settings()).damping;
  this->graph_ = std::make_unique<scheduler::StepGraph>(step_.phases(), join_blocks(blocks),
                                                        Step<T, D>::resources());
}

template <class T, int D>
double Solver<T, D>::time_step() const {
  if (const double rest = state_.clock.rest(); rest > 0) return rest;
  if (this->settings().time.step) return *this->settings().time.step;
  return cfl_number(this->settings()) * 2 / highest_frequency_;
}

template <class T, int D>
void Solver<T, D>::begin_step() {
  Clock& clock = state_.clock;
  const double start = clock.step_end, length = time_step();
  step_.prepare({start, length, clock.step % examine_every == 0});
  this->run(*this->graph_);
  check(step_.fold());
  for (Wall<D>& wall : state_.boundaries.walls) wall.move(start, length);
  clock.step_length = length;
  clock.step_end = start + length;
  clock.velocity_time =
      is_leapfrog(this->settings()) ? clock.step_end : clock.step_end - length / 2;
  ++clock.step;
  this->add_particle_stages(this->particles());
}

template <class T, int D>
void Solver<T, D>::check(const point_based::StepResult& result) const {
  if (result.non_finite < 0) return;
  const point_based::Body<T, D>& body = state_.bodies[state_.blocks[result.failed_block].body];
  throw failed_step(
      this->settings(), state_.clock,
      fmt::format("an element of body `{}` at the node that began at {} is no longer "
                  "finite or has turned inside out",
                  body.name, coordinates<D>(body.start[result.non_finite])),
      {smaller_step(this->settings()), "load more slowly", "use a mesh without flat elements"});
}

template <class T, int D>
std::size_t Solver<T, D>::bytes() const {
  std::size_t sum = 0;
  for (const point_based::Body<T, D>& body : state_.bodies) sum += body.bytes();
  for (const Elements<T, D>& elements : state_.elements) {
    sum += elements.corner.bytes() + elements.shape.bytes() + elements.pressure.bytes() +
           elements.initial_stress.bytes() + elements.slots.size() * sizeof(elements.slots[0]);
  }
  return sum;
}

template <class T, int D>
std::vector<double> Solver<T, D>::measure_each(std::span<const MeasurementCase> measurements) {
  return Measurer<T, D>(state_)(measurements);
}

template <class T, int D>
std::optional<EnergyBudget> Solver<T, D>::energy_budget() const {
  if (!is_leapfrog(this->settings())) return std::nullopt;
  return Base::energy_budget();
}

template <class T, int D>
BodyIntegrals Solver<T, D>::integrals() {
  return Measurer<T, D>(state_).totals();
}

template <class T, int D>
Frame Solver<T, D>::frame(const FrameParts& parts) {
  const std::vector<std::span<const point_based::CutSurface<D>>> no_cuts(state_.bodies.size());
  return point_based::take_frame<T, D>(state_, parts, no_cuts);
}

template <class T, int D>
std::vector<SlotRun> Solver<T, D>::particle_runs(int body) const {
  return point_based::particle_runs(state_.bodies.at(body));
}

template <class T, int D>
std::vector<std::array<double, 3>> Solver<T, D>::positions(int body) const {
  return point_based::positions(state_.bodies.at(body));
}

template <class T, int D>
void Solver<T, D>::save_state(ArchiveWriter& archive) const {
  point_based::put_state<T, D>(archive, state_);
}

template <class T, int D>
void Solver<T, D>::restore_state(const ArchiveReader& archive) {
  point_based::get_state<T, D>(archive, state_);
}

template class Solver<double, 2>;
template class Solver<double, 3>;
template class Solver<float, 2>;
template class Solver<float, 3>;

}  // namespace pliant::finite_elements

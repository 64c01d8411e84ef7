#include "engine/total_lagrangian/solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/case/stability.hpp"
#include "engine/lattice/layout_blocks.hpp"
#include "engine/method/initial_stress.hpp"
#include "engine/method/step_failure.hpp"
#include "engine/total_lagrangian/observe/field_views.hpp"
#include "engine/total_lagrangian/observe/frame.hpp"
#include "engine/total_lagrangian/observe/measure.hpp"
#include "engine/total_lagrangian/parameters.hpp"
#include "engine/total_lagrangian/setup.hpp"
#include "engine/total_lagrangian/state_archive.hpp"
#include "kernels/with_scalar.hpp"

namespace pliant::total_lagrangian {

namespace {

// Steps after which wave speed and soundness of the state are looked at again: waves go a few cells
// in that time, and the state hardly changes.
constexpr int examine_every = 8;

/// Whether a wall holds a corner of the cell above a slot: the stress at the edge of a clamp is
/// singular, and no step is short enough for it.
template <class T, int D>
bool is_held(const Body<T, D>& body, std::int64_t slot) {
  const auto corners = body.corners(body.layout.cell(slot));
  for (const auto& of_block : body.held) {
    for (const ConstrainedParticle<D>& held : of_block) {
      if (std::find(corners.begin(), corners.end(), held.slot) != corners.end()) return true;
    }
  }
  return false;
}

}  // namespace

template <class T, int D>
Solver<T, D>::Solver(const Case& a_case, const SolverOptions& options)
    : Base(a_case, options),
      state_(this->settings().boundaries),
      step_(state_, this->settings(), kernels::TotalLagrangianTable<T, D>::of(options.isa),
            this->workers()) {
  state_.bodies.resize(this->settings().bodies.size());
  Layouts<D> layouts;
  for (std::size_t b = 0; b < state_.bodies.size(); ++b) {
    Body<T, D>& body = state_.bodies[b];
    make_body<T, D>(this->settings(), this->settings().bodies[b], state_.boundaries, body);
    layouts.push_back(&body.layout);
    const BodyCase& source = this->settings().bodies[b];
    const double taut =
        wave_speed_under<D>(source, body.initial_stress, body.is_prestressed() ? body.slots : 0);
    state_.clock.wave_speed = std::max(state_.clock.wave_speed, taut);
    const double slack = kernels::wave_speed_at_rest(source.material);
    stress_wave_speed_ =
        std::max(stress_wave_speed_, std::sqrt(std::max(taut * taut - slack * slack, 0.)));
  }
  number_blocks<D>(layouts, state_.blocks);
  state_.clock.damping = parameters_of(this->settings()).damping.value_or(0);
  scale_mass();
  this->graph_ = std::make_unique<scheduler::StepGraph>(
      step_.phases(), connect_blocks<D>(layouts, 0), Step<T, D>::resources());
}

// Waves are slower by the square root of the scaling; "match_time_step" makes them as slow as the
// step needs at present.
template <class T, int D>
void Solver<T, D>::scale_mass() {
  const std::optional<double>& given = parameters_of(this->settings()).mass_scaling;
  double& scaling = state_.clock.mass_scaling = given.value_or(1);
  if (given) return;
  const double cells = state_.clock.wave_speed * *this->settings().time.step /
                       (cfl_number(this->settings()) * this->settings().discretisation.spacing);
  scaling = std::max(1.0, cells * cells);
}

template <class T, int D>
double Solver<T, D>::time_step() const {
  if (this->settings().time.step) return *this->settings().time.step;
  return cfl_number(this->settings()) * this->settings().discretisation.spacing *
         std::sqrt(state_.clock.mass_scaling) / state_.clock.wave_speed;
}

template <class T, int D>
void Solver<T, D>::begin_step() {
  Clock& clock = state_.clock;
  const double start = clock.step_end, previous = clock.step_length, length = time_step();
  const bool examine = clock.step % examine_every == 0;
  step_.prepare({start, previous, length, examine});
  this->run(*this->graph_);
  const StepResult result = step_.fold();
  check(result);
  for (Wall<D>& wall : state_.boundaries.walls) wall.move(start, length);
  clock.step_length = length;
  clock.step_end = start + length;
  clock.velocity_time = clock.step_end - length / 2;
  ++clock.step;
  if (!parameters_of(this->settings()).damping) {
    const double frequency2 = previous > 0 ? result.rayleigh / (previous * clock.mass_scaling) : 0;
    clock.damping = std::min(2 * std::sqrt(frequency2), 1 / length);
  }
  if (examine) {
    clock.wave_speed = stress_wave_speed_ > 0 ? std::hypot(result.wave_speed, stress_wave_speed_)
                                              : result.wave_speed;
    scale_mass();
  }
  this->add_particle_stages(this->particles());
}

template <class T, int D>
void Solver<T, D>::check(const StepResult& result) const {
  if (result.non_finite < 0) return;
  const BlockOwner owner = state_.blocks[result.failed_block];
  const Body<T, D>& body = state_.bodies[owner.body];
  const Point<D> x = body.lattice.node(body.layout.cell(result.non_finite));
  std::vector<std::string> remedies = {
      "raise the hourglass stiffness (total_lagrangian.hourglass_stiffness)", "load more slowly",
      "use a finer spacing"};
  if (!is_held(body, result.non_finite)) {
    remedies.insert(remedies.begin(), smaller_step(this->settings()));
  }
  throw failed_step(this->settings(), state_.clock,
                    fmt::format("the cell of body `{}` that began at {} is no longer finite or has "
                                "turned inside out",
                                body.name, coordinates<D>(x)),
                    remedies);
}

template <class T, int D>
std::size_t Solver<T, D>::bytes() const {
  std::size_t sum = 0;
  for (const Body<T, D>& body : state_.bodies) {
    body.for_each_array([&sum](Field, const auto components) {
      for (const Buffer<T>& component : components) sum += component.bytes();
    });
  }
  return sum;
}

template <class T, int D>
std::vector<double> Solver<T, D>::measure_each(std::span<const MeasurementCase> measurements) {
  return Measurer<T, D>(this->settings(), state_)(measurements);
}

template <class T, int D>
BodyIntegrals Solver<T, D>::integrals() {
  return Measurer<T, D>(this->settings(), state_).totals();
}

template <class T, int D>
Frame Solver<T, D>::frame(const FrameParts& parts) {
  return take_frame(state_, parts);
}

template <class T, int D>
std::vector<SlotRun> Solver<T, D>::particle_runs(int body) const {
  return total_lagrangian::particle_runs(state_.bodies.at(body));
}

template <class T, int D>
std::vector<std::array<double, 3>> Solver<T, D>::positions(int body) const {
  return total_lagrangian::positions(state_.bodies.at(body));
}

template <class T, int D>
void Solver<T, D>::save_state(ArchiveWriter& archive) const {
  put_state(archive, state_);
}

template <class T, int D>
void Solver<T, D>::restore_state(const ArchiveReader& archive) {
  get_state(archive, state_);
}

template class Solver<double, 2>;
template class Solver<double, 3>;
template class Solver<float, 2>;
template class Solver<float, 3>;

}  // namespace pliant::total_lagrangian

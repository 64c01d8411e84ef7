#include "engine/total_lagrangian/solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "engine/method/step_failure.hpp"
#include "engine/total_lagrangian/setup.hpp"

namespace pliant::total_lagrangian {

namespace {

// Steps after which wave speed and soundness of the state are looked at again: waves go a few cells
// in that time, and the state hardly changes.
constexpr int examine_every = 8;

}  // namespace

template <class T, int D>
Solver<T, D>::Solver(const Case& settings, int threads, kernels::Isa isa)
    : settings_(settings),
      workers_(threads),
      state_{{}, Boundaries<D>(settings_.boundaries), {}, {}},
      step_(state_, settings_, kernels::table<T, D>(isa)) {
  state_.bodies.resize(settings_.bodies.size());
  Layouts<D> layouts;
  for (std::size_t b = 0; b < state_.bodies.size(); ++b) {
    Body<T, D>& body = state_.bodies[b];
    body.material = settings_.bodies[b].material;
    make_body<T, D>(settings_, settings_.bodies[b], state_.boundaries, body);
    layouts.push_back(&body.layout);
    state_.clock.wave_speed = std::max(
        state_.clock.wave_speed, static_cast<double>(kernels::wave_speed_at_rest(body.material)));
  }
  number_blocks<D>(layouts, state_.blocks);
  state_.clock.damping = settings_.total_lagrangian.damping.value_or(0);
  scale_mass();
  graph_ = std::make_unique<scheduler::StepGraph>(step_.phases(), connect_blocks<D>(layouts, 0),
                                                  Step<T, D>::resources());
}

// Waves are slower by the square root of the scaling; "to_step" makes them as slow as the step
// needs at present.
template <class T, int D>
void Solver<T, D>::scale_mass() {
  const auto& method = settings_.total_lagrangian;
  double& scaling = state_.clock.mass_scaling = method.mass_scaling;
  if (!method.scale_to_step) return;
  const double cells = state_.clock.wave_speed * *settings_.time.step /
                       (settings_.time.cfl * settings_.discretisation.spacing);
  scaling = std::max(1.0, cells * cells);
}

template <class T, int D>
double Solver<T, D>::time_step() const {
  if (settings_.time.step) return *settings_.time.step;
  return settings_.time.cfl * settings_.discretisation.spacing *
         std::sqrt(state_.clock.mass_scaling) / state_.clock.wave_speed;
}

template <class T, int D>
void Solver<T, D>::step(double longest) {
  const auto start = std::chrono::steady_clock::now();
  Clock& clock = state_.clock;
  const double dt = step_length(settings_, clock, time_step(), longest);
  const bool examine = clock.step % examine_every == 0;
  step_.prepare(dt, examine);
  graph_->run(workers_);
  graph_->record().simulated_time = clock.time;
  totals_.add(graph_->record(), graph_->timer_names());
  const StepResult result = step_.fold();
  check(result);
  for (Wall<D>& wall : state_.boundaries.walls) wall.move(clock.time, dt);
  clock.time += dt;
  ++clock.step;
  if (!settings_.total_lagrangian.damping) {
    clock.damping = std::min(2 * std::sqrt(result.frequency2 / clock.mass_scaling), 1 / dt);
  }
  if (examine) {
    clock.wave_speed = result.wave_speed;
    scale_mass();
  }
  particle_stages_ += particles();
  loop_seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

template <class T, int D>
void Solver<T, D>::check(const StepResult& result) const {
  if (result.non_finite < 0) return;
  const BlockOwner owner = state_.blocks[result.failed_block];
  const Body<T, D>& body = state_.bodies[owner.body];
  const Point<D> x = body.lattice.node(body.layout.cell(result.non_finite));
  throw StepFailure(fmt::format(
      "t = {:.6g}, step {}: the cell of body `{}` that began at ({:.4g}, {:.4g}{}) is no longer "
      "finite or has turned inside out; use a smaller time step (time.cfl), more resistance to "
      "hourglasses (total_lagrangian.hourglass), slower loading, or a finer spacing",
      state_.clock.time, state_.clock.step, body.name, x[0], x[1],
      D == 3 ? fmt::format(", {:.4g}", x[D - 1]) : ""));
}

template <class T, int D>
std::int64_t Solver<T, D>::particles() const {
  std::int64_t sum = 0;
  for (const Body<T, D>& body : state_.bodies) sum += body.particles;
  return sum;
}

template class Solver<double, 2>;
template class Solver<double, 3>;

}  // namespace pliant::total_lagrangian

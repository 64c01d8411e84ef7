#include "engine/total_lagrangian/solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/case/checks/stability.hpp"
#include "engine/lattice/layout_blocks.hpp"
#include "engine/method/initial_stress.hpp"
#include "engine/total_lagrangian/parameters.hpp"
#include "engine/total_lagrangian/setup.hpp"
#include "engine/total_lagrangian/volumetric_mode.hpp"
#include "engine/undeformed/slip_walls.hpp"

namespace pliant::total_lagrangian {

namespace {

/// Whether a wall holds a corner of the cell above a slot. The stress at the edge of a clamp is
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

/// The ratio of c^2 of (TL.23) to that of waves at rest.
double breathing_ratio(const kernels::Material<double>& material, double factor) {
  const double mu = material.shear_modulus, lambda = material.bulk_modulus - 2. / 3 * mu;
  return std::max(1.0, (factor * lambda + 2 * mu) / (lambda + 2 * mu));
}

// Share of the limit (TL.23) that is safe in states that are not at rest. A clamped bar of one
// cell, nu = 0.49, that swings by a third of its length conserves its energy at 1.00 of the limit
// and fails at 1.03.
constexpr double safe_share = 0.95;

}  // namespace

template <class T, int D>
Solver<T, D>::Solver(const Case& a_case, const SolverOptions& options)
    : Base(undeformed::ended_at_slip_walls(a_case, [](const Shape&) { return false; }), options),
      cfl_(cfl_number(this->settings())) {
  State<T, D>& state = this->state();
  Layouts<D> layouts;
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    Body<T, D>& body = state.bodies[b];
    const BodyCase& source = this->settings().bodies[b];
    make_body<T, D>(this->settings(), source, state.boundaries, body);
    layouts.push_back(&body.layout);
    limit_cfl(source, body);
    const double taut =
        wave_speed_under<D>(source, body.initial_stress, body.is_prestressed() ? body.slots : 0);
    state.clock.wave_speed = std::max(state.clock.wave_speed, taut);
    const double slack = kernels::wave_speed_at_rest(source.material);
    stress_wave_speed_ =
        std::max(stress_wave_speed_, std::sqrt(std::max(taut * taut - slack * slack, 0.)));
  }
  number_blocks<D>(layouts, state.blocks);
  state.clock.damping = parameters_of(this->settings()).damping.value_or(0);
  scale_mass();
  this->set_step(std::make_unique<Step<T, D>>(state, this->settings(),
                                              kernels::TotalLagrangianTable<T, D>::of(options.isa),
                                              this->workers()),
                 connect_blocks<D>(layouts, 0));
}

template <class T, int D>
double Solver<T, D>::smallest_spacing() const {
  double least = std::numeric_limits<double>::infinity();
  for (const Body<T, D>& body : this->state().bodies) {
    least = std::min(least, body.lattice.spacing);
  }
  return least;
}

// Computes the factor only where it may limit the step: its upper bound is the dimension.
template <class T, int D>
void Solver<T, D>::limit_cfl(const BodyCase& source, const Body<T, D>& body) {
  const double worst = safe_share / std::sqrt(breathing_ratio(source.material, D));
  if (cfl_ <= worst) return;
  const double ratio = breathing_ratio(source.material, volumetric_mode_factor(body));
  cfl_ = std::min(cfl_, safe_share / std::sqrt(ratio));
}

// Mass scaling slows waves by its square root; "match_time_step" scales as much as the present step
// needs.
template <class T, int D>
void Solver<T, D>::scale_mass() {
  const std::optional<double>& given = parameters_of(this->settings()).mass_scaling;
  Clock& clock = this->state().clock;
  double& scaling = clock.mass_scaling = given.value_or(1);
  if (given) return;
  const double cells = clock.wave_speed * *this->settings().time.step / (cfl_ * smallest_spacing());
  scaling = std::max(1.0, cells * cells);
}

template <class T, int D>
double Solver<T, D>::automatic_step() const {
  const Clock& clock = this->clock();
  return cfl_ * smallest_spacing() * std::sqrt(clock.mass_scaling) / clock.wave_speed;
}

template <class T, int D>
void Solver<T, D>::adapt(const Advance& advance, const StepResult& result) {
  if (!advance.examine) return;
  this->state().clock.wave_speed = stress_wave_speed_ > 0
                                       ? std::hypot(result.wave_speed, stress_wave_speed_)
                                       : result.wave_speed;
  scale_mass();
}

template <class T, int D>
StepFailure Solver<T, D>::failure(const StepResult& result) const {
  const BlockOwner owner = this->state().blocks[result.failed_block];
  const Body<T, D>& body = this->state().bodies[owner.body];
  const Point<D> x = body.lattice.node(body.layout.cell(result.non_finite));
  std::vector<std::string> remedies = {
      "raise the hourglass stiffness (total_lagrangian.hourglass_stiffness)", "load more slowly",
      "use a finer spacing"};
  if (!is_held(body, result.non_finite)) {
    remedies.insert(remedies.begin(), smaller_step(this->settings()));
  }
  return failed_step(this->settings(), this->clock(),
                     fmt::format("the cell of body `{}` that began at {} is no longer finite or "
                                 "has turned inside out",
                                 body.name, coordinates<D>(x)),
                     remedies);
}

template class Solver<double, 2>;
template class Solver<double, 3>;
template class Solver<float, 2>;
template class Solver<float, 3>;

}  // namespace pliant::total_lagrangian

#include "engine/point_based/solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/case/stability.hpp"
#include "engine/method/initial_stress.hpp"
#include "engine/method/step_failure.hpp"
#include "engine/point_based/observe/field_views.hpp"
#include "engine/point_based/observe/frame.hpp"
#include "engine/point_based/observe/measure.hpp"
#include "engine/point_based/parameters.hpp"
#include "engine/point_based/setup.hpp"
#include "engine/point_based/state_archive.hpp"

namespace pliant::point_based {

namespace {

constexpr int examine_every = 8;      // steps
constexpr double stable_steps = 1.4;  // H/c, (PB.12)

}  // namespace

template <class T, int D>
Solver<T, D>::Solver(const Case& a_case, const SolverOptions& options)
    : Base(a_case, options),
      state_(this->settings().boundaries),
      step_(state_, cuts_, this->settings(), kernels::PointBasedTable<T, D>::of(options.isa)),
      resolution_(std::numeric_limits<double>::infinity()) {
  state_.bodies.resize(this->settings().bodies.size());
  std::vector<scheduler::Blocks> blocks;
  for (std::size_t b = 0; b < state_.bodies.size(); ++b) {
    Body<T, D>& body = state_.bodies[b];
    const BodyCase& source = this->settings().bodies[b];
    BondChoice<D> choice =
        make_body(this->settings(), source, place_nodes<D>(this->settings(), source),
                  state_.boundaries, body);
    cuts_.push_back(body.has_cuts()
                        ? std::make_unique<BodyCuts<T, D>>(this->settings(), static_cast<int>(b),
                                                           std::move(choice), body)
                        : nullptr);
    blocks.push_back(body.adjacency);
    number_blocks(static_cast<int>(b), body.adjacency.count(), state_.blocks);
    resolution_ = std::min(resolution_, body.resolution);
    const std::int64_t stressed = body.is_prestressed() ? body.slots : 0;
    state_.clock.wave_speed = std::max(state_.clock.wave_speed,
                                       wave_speed_under<D>(source, body.initial_stress, stressed));
  }
  state_.clock.damping = parameters_of(this->settings()).damping;
  this->graph_ = std::make_unique<scheduler::StepGraph>(step_.phases(), join_blocks(blocks),
                                                        Step<T, D>::resources());
}

template <class T, int D>
double Solver<T, D>::time_step() const {
  if (const double rest = state_.clock.rest(); rest > 0) return rest;
  if (this->settings().time.step) return *this->settings().time.step;
  return cfl_number(this->settings()) * stable_steps * resolution_ / state_.clock.wave_speed;
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
  const bool is_leapfrog = parameters_of(this->settings()).integrator == Integrator::leapfrog;
  clock.velocity_time = is_leapfrog ? clock.step_end : clock.step_end - length / 2;
  ++clock.step;
  this->add_particle_stages(this->particles());
}

template <class T, int D>
void Solver<T, D>::check(const StepResult& result) const {
  if (result.non_finite < 0) return;
  const Body<T, D>& body = state_.bodies[state_.blocks[result.failed_block].body];
  throw failed_step(this->settings(), state_.clock,
                    fmt::format("the node of body `{}` that began at {} is no longer finite or has "
                                "turned inside out",
                                body.name, coordinates<D>(body.start[result.non_finite])),
                    {smaller_step(this->settings()), "load more slowly",
                     "raise the stabilisation (point_based.stabilisation)", "use a finer spacing"});
}

template <class T, int D>
std::size_t Solver<T, D>::bytes() const {
  std::size_t sum = 0;
  for (const Body<T, D>& body : state_.bodies) sum += body.bytes();
  return sum;
}

template <class T, int D>
std::vector<double> Solver<T, D>::measure_each(std::span<const MeasurementCase> measurements) {
  return Measurer<T, D>(state_)(measurements);
}

template <class T, int D>
std::optional<EnergyBudget> Solver<T, D>::energy_budget() const {
  const auto& method = parameters_of(this->settings());
  if (method.integrator != Integrator::leapfrog || method.stiffness_damping > 0) {
    return std::nullopt;
  }
  return Base::energy_budget();
}

template <class T, int D>
BodyIntegrals Solver<T, D>::integrals() {
  return Measurer<T, D>(state_).totals();
}

template <class T, int D>
Frame Solver<T, D>::frame(const FrameParts& parts) {
  std::vector<std::span<const CutSurface<D>>> surfaces(state_.bodies.size());
  for (std::size_t b = 0; b < surfaces.size(); ++b) {
    if (cuts_[b]) surfaces[b] = cuts_[b]->surfaces();
  }
  return take_frame<T, D>(state_, parts, surfaces);
}

template <class T, int D>
void Solver<T, D>::put_blade(std::size_t cut, const std::array<double, 3>& from,
                             const std::array<double, 3>& to) {
  Point<D> begin, end;
  std::copy_n(from.begin(), D, begin.begin());
  std::copy_n(to.begin(), D, end.begin());
  const int owner = this->settings().cuts.at(cut).body;
  cuts_[owner]->put_blade(cut, begin, end, state_.bodies[owner]);
}

template <class T, int D>
void Solver<T, D>::lift_blade(std::size_t cut) {
  cuts_[this->settings().cuts.at(cut).body]->lift_blade(cut);
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
  put_state(archive, state_);
  for (std::size_t b = 0; b < cuts_.size(); ++b) {
    if (cuts_[b]) cuts_[b]->put(archive, fmt::format("body/{}/cuts", b));
  }
}

template <class T, int D>
void Solver<T, D>::restore_state(const ArchiveReader& archive) {
  get_state(archive, state_);
  for (std::size_t b = 0; b < cuts_.size(); ++b) {
    if (cuts_[b]) cuts_[b]->get(archive, fmt::format("body/{}/cuts", b), state_.bodies[b]);
  }
}

template class Solver<double, 2>;
template class Solver<double, 3>;
template class Solver<float, 2>;
template class Solver<float, 3>;

}  // namespace pliant::point_based

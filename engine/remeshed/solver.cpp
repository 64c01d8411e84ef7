#include "engine/remeshed/solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "engine/remeshed/resources.hpp"
#include "engine/remeshed/setup.hpp"

namespace pliant::remeshed {

namespace {

// Plain SPH has the kernel (RP.13) whatever the weight of the moment matrix would be.
kernels::Weight search_weight(const Case& settings) {
  return is_plain_sph(settings) ? kernels::Weight::quartic : settings.discretisation.weight;
}

template <class T, int D>
Layouts<D> layouts_of(const std::vector<Body<T, D>>& bodies, Population<T, D> Body<T, D>::*slots) {
  Layouts<D> layouts;
  for (const Body<T, D>& body : bodies) layouts.push_back(&(body.*slots).layout);
  return layouts;
}

}  // namespace

template <class T, int D>
Solver<T, D>::Solver(const Case& settings, int threads, kernels::Isa isa)
    : settings_(settings),
      workers_(threads),
      kernels_(kernels::table<T, D>(isa)),
      state_(make_state<T, D>(settings_)),
      layouts_(layouts_of(state_.bodies, &Body<T, D>::population)),
      spare_layouts_(layouts_of(state_.bodies, &Body<T, D>::spare)),
      step_(state_, settings_, kernels_),
      search_(state_, search_weight(settings_), is_plain_sph(settings_)),
      listed_(state_.bodies.size()) {
  for (std::size_t b = 0; b < state_.bodies.size(); ++b) {
    remeshings_.push_back(std::make_unique<Remeshing<T, D>>(settings_, state_.bodies[b],
                                                            state_.boundaries, kernels_, workers_));
    remeshings_.back()->place_initial(settings_);
    remeshings_.back()->prepare_target(false, true);
  }
  scheduler::StepGraph initial(target_phases(false), connect_blocks<D>(spare_layouts_, 0),
                               resource::names());
  initial.run(workers_);
  for (auto& remeshing : remeshings_) remeshing->commit();
  number_blocks<D>(layouts_, state_.blocks);
  step_.momentum().open();
  adopt();
}

template <class T, int D>
double Solver<T, D>::time_step() const {
  if (settings_.time.step) return *settings_.time.step;
  return settings_.time.cfl * settings_.discretisation.spacing / state_.clock.wave_speed;
}

template <class T, int D>
void Solver<T, D>::step(double longest) {
  const auto start = std::chrono::steady_clock::now();
  Clock& clock = state_.clock;
  const double dt = step_length(settings_, clock, time_step(), longest);
  step_.prepare(dt);
  find_neighbours(dt);
  run(*present_graph_);
  step_.fold();
  check(step_.result());
  for (Wall<D>& wall : state_.boundaries.walls) wall.move(clock.time, dt);
  clock.time += dt;
  ++clock.step;
  ++clock.steps_since_remeshing;
  ++clock.steps_since_reinitialisation;
  clock.accumulated_strain += dt * step_.result().strain_rate;
  clock.wave_speed = step_.result().wave_speed;
  add_strain(dt);
  particle_stages_ += 4 * particles();
  if (remeshing_due()) remesh();
  loop_seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

template <class T, int D>
bool Solver<T, D>::remeshing_due() const {
  using Policy = decltype(Case{}.remeshing)::Policy;
  switch (settings_.remeshing.policy) {
    case Policy::every:
      return state_.clock.steps_since_remeshing >= settings_.remeshing.every;
    case Policy::adaptive:
      return state_.clock.accumulated_strain > settings_.remeshing.strain;
    case Policy::never:
      return false;
  }
  return false;
}

template <class T, int D>
void Solver<T, D>::remesh() {
  Clock& clock = state_.clock;
  const bool reinitialise =
      clock.steps_since_reinitialisation >= settings_.level_set.reinitialise_every;
  remesh_onto_spare(reinitialise, true);
  if (reinitialise) clock.steps_since_reinitialisation = 0;
  ++clock.remeshings;
  clock.steps_since_remeshing = 0;
  clock.accumulated_strain = 0;
  for (Body<T, D>& body : state_.bodies) body.neighbours.strain = 0;
  for (auto& remeshing : remeshings_) remeshing->commit();
  adopt();
}

template <class T, int D>
void Solver<T, D>::remesh_onto_spare(bool reinitialise, bool is_final) {
  step_.prepare(0);
  run(source_graph_.over(layouts_, [&] { return source_phases(); }));
  for (auto& remeshing : remeshings_) remeshing->prepare_target(reinitialise, is_final);
  run(target_graph_.over(spare_layouts_, [&] { return target_phases(true); }));
}

template <class T, int D>
std::vector<scheduler::Phase> Solver<T, D>::source_phases() {
  std::vector<scheduler::Phase> phases = step_.ghost_phases();
  int first = 0;
  for (std::size_t b = 0; b < remeshings_.size(); ++b) {
    remeshings_[b]->source_phases(phases, first);
    first += static_cast<int>(layouts_[b]->blocks().size());
  }
  return phases;
}

template <class T, int D>
std::vector<scheduler::Phase> Solver<T, D>::target_phases(bool from_particles) {
  std::vector<scheduler::Phase> phases;
  int first = 0;
  for (std::size_t b = 0; b < remeshings_.size(); ++b) {
    remeshings_[b]->target_phases(phases, first, from_particles);
    first += static_cast<int>(spare_layouts_[b]->blocks().size());
  }
  return phases;
}

template <class T, int D>
void Solver<T, D>::adopt() {
  check_bodies();
  restored();
  run(stress_graph_.over(layouts_, [&] { return step_.stress_phases(); }));
  step_.fold();
  check(step_.result());
  state_.clock.wave_speed = step_.result().wave_speed;
}

template <class T, int D>
void Solver<T, D>::restored() {
  number_blocks<D>(layouts_, state_.blocks);
  search_.clear();
  present_graph_ = &step_graph_.over(layouts_, [&] { return step_.phases(); });
}

// The step over listed neighbours has a graph of its own, and both are kept: bodies that strain
// much between remeshings go from one to the other and back.
template <class T, int D>
void Solver<T, D>::find_neighbours(double time_step) {
  if (!search_.is_due(time_step)) return;
  run(search_graph_.over(layouts_, [&] { return search_.phases(); }));
  const auto is_listed = [](const Body<T, D>& body) { return body.neighbours.are_listed; };
  if (std::none_of(state_.bodies.begin(), state_.bodies.end(), is_listed)) return;
  for (std::size_t b = 0; b < state_.bodies.size(); ++b) {
    if (listed_[b] == is_listed(state_.bodies[b])) continue;
    listed_[b] = !listed_[b];
    listed_step_graph_.drop();
  }
  present_graph_ = &listed_step_graph_.over(layouts_, [&] { return step_.phases(); });
}

template <class T, int D>
void Solver<T, D>::add_strain(double time_step) {
  for (std::size_t b = 0; b < state_.bodies.size(); ++b) {
    BodyNeighbours<D>& neighbours = state_.bodies[b].neighbours;
    neighbours.strain_rate = step_.strain_rate(static_cast<int>(b));
    neighbours.strain += time_step * neighbours.strain_rate;
  }
}

template <class T, int D>
void Solver<T, D>::run(scheduler::StepGraph& graph) {
  graph.run(workers_);
  graph.record().simulated_time = state_.clock.time;
  totals_.add(graph.record(), graph.timer_names());
}

template <class T, int D>
void Solver<T, D>::check(const kernels::StageResult& result) const {
  if (result.non_finite < 0) return;
  const BlockOwner owner = state_.blocks[step_.failed_block()];
  const Body<T, D>& body = state_.bodies[owner.body];
  const Point<D> x = body.lattice.node(body.population.layout.cell(result.non_finite));
  throw StepFailure(
      fmt::format("t = {:.6g}, step {}: particle {} of body `{}` near ({:.4g}, {:.4g}) is no "
                  "longer finite or has "
                  "lost its volume; use a smaller time step (time.cfl), remesh more often "
                  "(remeshing.strain), or "
                  "use a finer spacing",
                  state_.clock.time, state_.clock.step, result.non_finite, body.name, x[0], x[1]));
}

// A body that blows up may be flung off its level set within one remeshing, finite to the last.
template <class T, int D>
void Solver<T, D>::check_bodies() const {
  for (const Body<T, D>& body : state_.bodies) {
    if (body.population.particles > 0) continue;
    throw StepFailure(
        fmt::format("t = {:.6g}, step {}: body `{}` has no particle left; look at the last frames "
                    "for where it broke, then use a smaller time step (time.cfl), remesh more "
                    "often (remeshing.every), or use a finer spacing",
                    state_.clock.time, state_.clock.step, body.name));
  }
}

template <class T, int D>
std::int64_t Solver<T, D>::particles() const {
  std::int64_t sum = 0;
  for (const Body<T, D>& body : state_.bodies) sum += body.population.particles;
  return sum;
}

template <class T, int D>
std::int64_t Solver<T, D>::ghosts() const {
  std::int64_t sum = 0;
  for (const Body<T, D>& body : state_.bodies) {
    for (const BlockGhosts<T, D>& block : body.population.ghosts) {
      sum += static_cast<std::int64_t>(block.slot.size() - block.contact.size());
    }
  }
  return sum;
}

template <class T, int D>
std::vector<LatticeView<T, D>> Solver<T, D>::on_nodes() {
  const bool fresh = is_fresh();
  if (!fresh) remesh_onto_spare(false, false);
  std::vector<LatticeView<T, D>> views;
  for (const Body<T, D>& body : state_.bodies) {
    views.push_back({body, fresh ? body.population : body.spare, body.stage[fresh ? 0 : 1]});
  }
  return views;
}

template <class T, int D>
void Solver<T, D>::refresh_ghosts() {
  step_.prepare(0);
  run(ghost_graph_.over(layouts_, [&] { return step_.ghost_phases(); }));
}

template <class T, int D>
std::size_t Solver<T, D>::bytes() const {
  std::size_t sum = 0;
  for (const Body<T, D>& body : state_.bodies) {
    for (const auto& store : body.stage) sum += store.bytes();
    for (const auto& component : body.stress) sum += component.bytes();
    sum += body.last_odd_stress.bytes() + body.interior.bytes() + body.volume_change.bytes();
    sum += body.neighbours.bytes() + body.records.bytes();
  }
  return sum;
}

template class Solver<double, 2>;
template class Solver<double, 3>;

}  // namespace pliant::remeshed

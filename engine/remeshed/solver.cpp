#include "engine/remeshed/solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>

#include "engine/remeshed/resources.hpp"
#include "engine/remeshed/setup.hpp"

namespace pliant::remeshed {

namespace {

template <class T, int D>
State<T, D> empty_state(const Case& settings) {
  State<T, D> state{{}, Boundaries<D>(settings.boundaries), {}, {}, {}, {}, {}};
  state.wall_impulse.resize(state.boundaries.walls.size());
  state.contact_impulse.resize(settings.contacts.size());
  state.bodies.resize(settings.bodies.size());
  return state;
}

template <class T>
kernels::Material<T> converted(const kernels::Material<double>& m) {
  kernels::Material<T> material;
  material.model = m.model;
  material.density = static_cast<T>(m.density);
  material.bulk_modulus = static_cast<T>(m.bulk_modulus);
  material.shear_modulus = static_cast<T>(m.shear_modulus);
  material.order = m.order;
  for (std::size_t n = 0; n < m.coefficient.size(); ++n) {
    material.coefficient[n] = static_cast<T>(m.coefficient[n]);
  }
  material.compressibility = static_cast<T>(m.compressibility);
  return material;
}

// Cells by which blocks may come nearer to each other before a graph has to be built again.
constexpr int graph_slack = 4;

bool is_plain_sph(const Case& settings) {
  return settings.discretisation.operators == Operators::symmetric_sph;
}

// Plain SPH has the kernel (RP.13) whatever the weight of the moment matrix would be.
kernels::Weight search_weight(const Case& settings) {
  return is_plain_sph(settings) ? kernels::Weight::quartic : settings.discretisation.weight;
}

// Shares of a period or of a spacing that rounding may leave between two times.
constexpr double rounding = 1e-9;

}  // namespace

template <class T, int D>
Solver<T, D>::Solver(const Case& settings, int threads, kernels::Isa isa)
    : settings_(settings),
      workers_(threads),
      kernels_(kernels::table<T, D>(isa)),
      state_(empty_state<T, D>(settings_)),
      step_(state_, settings_, kernels_),
      search_(state_, search_weight(settings_), is_plain_sph(settings_)),
      listed_(state_.bodies.size()) {
  for (std::size_t b = 0; b < settings_.bodies.size(); ++b) {
    Body<T, D>& body = state_.bodies[b];
    const BodyCase& source = settings_.bodies[b];
    body.name = source.name;
    body.source = &source;
    body.material = converted<T>(source.material);
    body.is_plain_sph = is_plain_sph(settings_);
    for (const kernels::PronyTerm<double>& term : source.prony) {
      body.prony.push_back({static_cast<T>(term.ratio), static_cast<T>(term.time)});
    }
    body.lattice = body_lattice<D>(settings_, source);
    for (int buffer = 0; buffer < 3; ++buffer) {
      body.stage[buffer] =
          FieldStore<T, D>(body.material.model, static_cast<int>(body.prony.size()), buffer > 1);
    }
    remeshings_.push_back(
        std::make_unique<Remeshing<T, D>>(settings_, body, state_.boundaries, kernels_, workers_));
    remeshings_.back()->place_initial(settings_, source);
  }
  std::vector<scheduler::Phase> phases;
  int first = 0;
  for (auto& remeshing : remeshings_) {
    remeshing->prepare_arrival(false, true);
    remeshing->arrival_phases(phases, first, false);
    first += static_cast<int>(
        state_.bodies[&remeshing - remeshings_.data()].spare.layout.blocks().size());
  }
  scheduler::StepGraph initial(std::move(phases), blocks(true), resource::names());
  initial.run(workers_);
  for (auto& remeshing : remeshings_) remeshing->commit();
  number_blocks();
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
  double dt = time_step();
  if (dt > longest * (1 - rounding)) dt = longest;
  if (!(dt > 1e-12 * settings_.time.end)) {
    throw StepFailure(
        fmt::format("t = {:.6g}: the time step has collapsed to {:.3g} s (largest wave speed "
                    "{:.3g} m/s); check "
                    "the material constants and the loading, or use a finer spacing",
                    clock.time, dt, clock.wave_speed));
  }
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
  if (remeshing_due()) {
    const bool reinitialise =
        clock.steps_since_reinitialisation >= settings_.level_set.reinitialise_every;
    remesh_onto_spare(reinitialise, true);
    if (reinitialise) clock.steps_since_reinitialisation = 0;
    ++clock.remeshings;
    clock.steps_since_remeshing = 0;
    clock.accumulated_strain = 0;
    for (Body<T, D>& body : state_.bodies) body.neighbours.strain = 0;
    commit();
  }
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
void Solver<T, D>::remesh_onto_spare(bool reinitialise, bool is_final) {
  step_.prepare(0);
  const auto each_body = [&](bool spare, auto add) {
    std::vector<scheduler::Phase> phases;
    int first = 0;
    for (std::size_t b = 0; b < remeshings_.size(); ++b) {
      add(phases, *remeshings_[b], first);
      const Body<T, D>& body = state_.bodies[b];
      first += static_cast<int>((spare ? body.spare : body.population).layout.blocks().size());
    }
    return phases;
  };
  run(graph_for(departure_graph_, false, [&] {
    std::vector<scheduler::Phase> phases = step_.ghost_phases();
    for (auto& phase : each_body(false, [](auto&list, auto&remeshing, int first) {
           remeshing.departure_phases(list, first);
         })) {
      phases.push_back(std::move(phase));
    }
    return phases;
  }));
  for (auto& remeshing : remeshings_) remeshing->prepare_arrival(reinitialise, is_final);
  run(graph_for(arrival_graph_, true, [&] {
    return each_body(true, [](auto& list, auto& remeshing, int first) {
      remeshing.arrival_phases(list, first, true);
    });
  }));
}

template <class T, int D>
void Solver<T, D>::commit() {
  for (auto& remeshing : remeshings_) remeshing->commit();
  adopt();
}

template <class T, int D>
void Solver<T, D>::adopt() {
  check_bodies();
  restored();
  run(graph_for(stress_graph_, false, [&] { return step_.stress_phases(); }));
  step_.fold();
  check(step_.result());
  state_.clock.wave_speed = step_.result().wave_speed;
}

template <class T, int D>
void Solver<T, D>::restored() {
  number_blocks();
  search_.forget();
  present_graph_ = &graph_for(step_graph_, false, [&] { return step_.phases(); });
}

// The step over listed neighbours has a graph of its own, and both are kept: bodies that strain
// much between remeshings go from one to the other and back.
template <class T, int D>
void Solver<T, D>::find_neighbours(double time_step) {
  if (!search_.is_due(time_step)) return;
  run(graph_for(search_graph_, false, [&] { return search_.phases(); }));
  const auto is_listed = [](const Body<T, D>& body) { return body.neighbours.are_listed; };
  if (std::none_of(state_.bodies.begin(), state_.bodies.end(), is_listed)) return;
  for (std::size_t b = 0; b < state_.bodies.size(); ++b) {
    if (listed_[b] == is_listed(state_.bodies[b])) continue;
    listed_[b] = !listed_[b];
    listed_step_graph_.steps.reset();
  }
  present_graph_ = &graph_for(listed_step_graph_, false, [&] { return step_.phases(); });
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
void Solver<T, D>::number_blocks() {
  state_.blocks.clear();
  for (std::size_t b = 0; b < state_.bodies.size(); ++b) {
    const int count = static_cast<int>(state_.bodies[b].population.layout.blocks().size());
    for (int i = 0; i < count; ++i) state_.blocks.push_back({static_cast<int>(b), i});
  }
}

template <class T, int D>
scheduler::Blocks Solver<T, D>::blocks(bool spare) const {
  scheduler::Blocks blocks;
  for (const Body<T, D>& body : state_.bodies) {
    const int first = blocks.count();
    const Layout<D>& layout = (spare ? body.spare : body.population).layout;
    for (const auto& near : layout.neighbours_and(graph_slack)) {
      blocks.neighbours.emplace_back(near);
      for (int& b : blocks.neighbours.back()) b += first;
    }
  }
  return blocks;
}

// Neighbours that a block has no longer do no harm: they only restrict the order of nodes.
template <class T, int D>
bool Solver<T, D>::serves(const Graph& graph, bool spare) const {
  if (!graph.steps) return false;
  const auto& listed = graph.steps->blocks().neighbours;
  std::size_t first = 0;
  for (std::size_t body = 0; body < state_.bodies.size(); ++body) {
    const Body<T, D>& owner = state_.bodies[body];
    const auto& neighbours = (spare ? owner.spare : owner.population).layout.neighbours();
    if (graph.block_counts[body] != neighbours.size()) return false;
    for (std::size_t b = 0; b < neighbours.size(); ++b) {
      const auto& known = listed[first + b];
      for (const int near : neighbours[b]) {
        if (!std::binary_search(known.begin(), known.end(), near + static_cast<int>(first))) {
          return false;
        }
      }
    }
    first += neighbours.size();
  }
  return true;
}

// As long as the bodies keep their numbers of blocks, a new graph keeps the neighbours of the old
// one too: where blocks come near and part again, as those of a body that breathes do, building a
// graph at every remeshing would cost a small body a tenth of its time.
template <class T, int D>
template <class F>
scheduler::StepGraph& Solver<T, D>::graph_for(Graph& graph, bool spare, F&& make_phases) {
  if (serves(graph, spare)) return *graph.steps;
  std::vector<std::size_t> counts;
  for (const Body<T, D>& body : state_.bodies) {
    counts.push_back((spare ? body.spare : body.population).layout.blocks().size());
  }
  scheduler::Blocks present = blocks(spare);
  if (graph.steps && graph.block_counts == counts) {
    for (int b = 0; b < present.count(); ++b) {
      const auto& before = graph.steps->blocks().neighbours[b];
      std::vector<scheduler::BlockId> all;
      std::set_union(before.begin(), before.end(), present.neighbours[b].begin(),
                     present.neighbours[b].end(), std::back_inserter(all));
      present.neighbours[b] = std::move(all);
    }
  }
  graph.steps = std::make_unique<scheduler::StepGraph>(make_phases(), present, resource::names());
  graph.block_counts = std::move(counts);
  return *graph.steps;
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
  run(graph_for(ghost_graph_, false, [&] { return step_.ghost_phases(); }));
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

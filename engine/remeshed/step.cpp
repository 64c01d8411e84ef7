#include "engine/remeshed/step.hpp"

#include <algorithm>

#include "engine/remeshed/contact.hpp"
#include "engine/remeshed/ghost_fits.hpp"
#include "engine/remeshed/pair_stress.hpp"
#include "engine/remeshed/resources.hpp"
#include "kernels/relaxation.hpp"

// A step of the remeshed Lagrangian particle method (H&K, sections 2 and 4).
//
//   for each stage s = 0..3 of the Runge-Kutta method (RP.19), stage states Q0, Q2, Q3, Q4 (where
//   Q2 was):
//     surface   grad phi of the particles near the surface (RP.81); their u, sigma, grad phi, p are
//               packed side by side, one cache line each
//     contact   first stage only: which ghosts beyond a contact wall the body presses on, (RP.50)
//     ghosts    each ghost takes velocity and stress from the packed particles: the free surface
//               with its present normal (RP.37), (RP.34), walls (RP.35), (RP.36), as the paper
//               (RP.38); contact walls let go where they would pull
//     advance   grad u and div sigma of every particle by the moment matrix (RP.18), its rates
//               (RP.12), the next stage state and the stress that belongs to it (RP.3)-(RP.9)
//
// Plain SPH, the paper's baseline, has no ghosts: (RP.73) and (RP.74) over listed neighbours take
// the place of (RP.18), and of surface, contact and ghosts
//     pair stress   sigma/rho^2 of every particle, and its artificial stress (RP.76)
//
// A step only follows particles. Moving them back onto the lattice is in remesh.cpp; when that is
// due is decided in solver.cpp.
namespace pliant::remeshed {

using scheduler::Phase;
using scheduler::Reach;

template <class T, int D>
Step<T, D>::Step(State<T, D>& state, const Case& settings, const kernels::Table<T, D>& kernels)
    : state_(state),
      settings_(settings),
      kernels_(kernels),
      contact_(state, settings, kernels),
      momentum_(state, settings) {}

template <class T, int D>
std::vector<Phase> Step<T, D>::phases() {
  results_.assign(state_.blocks.size(), {0, 0, -1});
  std::vector<Phase> phases;
  for (int stage = 0; stage < 4; ++stage) {
    is_plain_sph() ? add_pair_stress(phases, stage)
                   : add_ghosts(phases, stage, WhichGhosts::reached);
    add_advance(phases, stage);
  }
  if (momentum_.is_needed()) {
    momentum_.add_phases(
        phases, [this]() -> const auto& { return contact_.fold(); });
  }
  return phases;
}

template <class T, int D>
std::vector<Phase> Step<T, D>::ghost_phases() {
  std::vector<Phase> phases;
  add_ghosts(phases, 0, WhichGhosts::all);
  return phases;
}

template <class T, int D>
std::vector<Phase> Step<T, D>::stress_phases() {
  results_.assign(state_.blocks.size(), {0, 0, -1});
  std::vector<Phase> phases = {{"stress",
                                -1,
                                {{resource::material(0)}},
                                {{resource::stress(0)}},
                                Phase::Extent::per_block,
                                {},
                                [this](int block) { evaluate_stress(block); }}};
  if (momentum_.is_needed()) {
    momentum_.add_phases(phases, {});
  }
  return phases;
}

template <class T, int D>
void Step<T, D>::add_ghosts(std::vector<Phase>& phases, int stage, WhichGhosts which) {
  const int parity = stage % 2, buffer = buffer_of(stage);
  const auto each = [&](const char* name, std::vector<scheduler::Access> reads,
                        std::vector<scheduler::Access> writes, auto run) {
    phases.push_back({name,
                      stage,
                      std::move(reads),
                      std::move(writes),
                      Phase::Extent::per_block,
                      {},
                      [this, stage, run](int block) { (this->*run)(block, stage); }});
  };
  if (periodic()) {
    each("image positions", {{resource::drift(buffer), Reach::neighbours}},
         {{resource::image_drift(buffer)}}, &Step::copy_image_drift);
  }
  each("surface",
       {{resource::drift(buffer), Reach::neighbours},
        {resource::image_drift(buffer)},
        {resource::velocity(buffer)},
        {resource::stress(parity)},
        {resource::material(buffer)}},
       {{resource::records}}, &Step::write_records);
  const bool contact = state_.boundaries.have_contact();
  if (contact && stage == 0) {
    each("contact", {{resource::records, Reach::neighbours}, {resource::drift(buffer)}},
         {{resource::contact}}, &Step::decide_contact);
  }
  if (contact_.is_needed()) {
    if (stage == 0) contact_.add_search(phases);
    contact_.add_tractions(phases, stage);
  }
  std::vector<scheduler::Access> reads = {{resource::records, Reach::neighbours},
                                          {resource::tractions},
                                          {resource::drift(buffer), Reach::neighbours},
                                          {resource::velocity(buffer), Reach::neighbours}};
  std::vector<scheduler::Access> writes = {{resource::ghosts(buffer)}};
  if (contact) {
    writes.insert(writes.end(), {{resource::contact}, {resource::impulse}});
  }
  if (which == WhichGhosts::all) {
    each("ghosts", std::move(reads), std::move(writes), &Step::fill_all);
  } else {
    if (stage == 2) reads.insert(reads.end(), {{resource::ghosts(0)}, {resource::ghosts(1)}});
    if (stage == 3) reads.push_back({resource::ghosts(2)});
    each("ghosts", std::move(reads), std::move(writes), &Step::fill);
  }
  if (periodic()) {
    each("images",
         {{resource::velocity(buffer), Reach::neighbours},
          {resource::stress(parity), Reach::neighbours},
          {resource::ghosts(buffer), Reach::neighbours}},
         {{resource::images(buffer)}}, &Step::copy_images);
  }
}

template <class T, int D>
bool Step<T, D>::is_plain_sph() const {
  return settings_.discretisation.operators == Operators::symmetric_sph;
}

template <class T, int D>
void Step<T, D>::add_pair_stress(std::vector<Phase>& phases, int stage) {
  phases.push_back({"pair stress",
                    stage,
                    {{resource::stress(stage % 2)}, {resource::material(buffer_of(stage))}},
                    {{resource::pair_stress}},
                    Phase::Extent::per_block,
                    {},
                    [this, stage](int block) {
                      const auto [body, local] = owner(block);
                      find_pair_stress<T, D>(body, local, stage,
                                             settings_.discretisation.artificial_stress);
                    }});
}

template <class T, int D>
std::vector<int> Step<T, D>::blocks_where(bool listed) const {
  std::vector<int> blocks;
  for (std::size_t b = 0; b < state_.blocks.size(); ++b) {
    if (state_.bodies[state_.blocks[b].body].neighbours.are_listed == listed) {
      blocks.push_back(static_cast<int>(b));
    }
  }
  return blocks;
}

// Neighbours that a search has found may belong to any block: particles far apart on the lattice
// may have come near. Everything else in a step stays on the lattice: fourth differences (RP.43)
// and grad phi of surface particles (RP.81) follow material lines, and ghosts keep their fits.
template <class T, int D>
void Step<T, D>::add_advance(std::vector<Phase>& phases, int stage) {
  std::vector<int> listed = blocks_where(true);
  if (listed.empty()) return add_advance(phases, stage, Reach::neighbours, {});
  std::vector<int> others = blocks_where(false);
  if (others.empty()) return add_advance(phases, stage, Reach::all, {});
  add_advance(phases, stage, Reach::neighbours, std::move(others));
  add_advance(phases, stage, Reach::all, std::move(listed));
}

template <class T, int D>
void Step<T, D>::add_advance(std::vector<Phase>& phases, int stage, Reach reach,
                             std::vector<int> blocks) {
  const int parity = stage % 2, current = buffer_of(stage), next = buffer_after(stage);
  std::vector<scheduler::Access> reads = {{resource::drift(current), reach},
                                          {resource::velocity(current), reach},
                                          {resource::stress(parity), reach},
                                          {resource::ghosts(current), reach},
                                          {resource::images(current), Reach::neighbours},
                                          {resource::material(current)}};
  if (is_plain_sph()) {
    reads.insert(reads.end(),
                 {{resource::pair_stress, reach}, {resource::material(current), reach}});
  }
  std::vector<scheduler::Access> writes = {{resource::stress(1 - parity)},
                                           {resource::ghosts(next)},
                                           {resource::image_drift(next)},
                                           {resource::images(next)},
                                           {resource::result}};
  for (int buffer = 0; buffer <= std::min(stage, 2); ++buffer) {
    reads.insert(
        reads.end(),
        {{resource::drift(buffer)}, {resource::velocity(buffer)}, {resource::material(buffer)}});
  }
  const auto write_state = [&](int buffer) {
    writes.insert(
        writes.end(),
        {{resource::drift(buffer)}, {resource::velocity(buffer)}, {resource::material(buffer)}});
  };
  write_state(next);
  if (stage == 2) write_state(0);
  phases.push_back({"advance", stage, std::move(reads), std::move(writes), Phase::Extent::per_block,
                    std::move(blocks), [this, stage](int block) { advance(block, stage); }});
}

template <class T, int D>
bool Step<T, D>::periodic() const {
  return std::any_of(state_.bodies.begin(), state_.bodies.end(),
                     [](const Body<T, D>& body) { return body.lattice.period != Cell<D>{}; });
}

template <class T, int D>
void Step<T, D>::prepare(double time_step) {
  time_step_ = time_step;
  contact_.prepare(time_step);
  impulse_.assign(state_.blocks.size() * state_.boundaries.walls.size(), {});
  for (int stage = 0; stage < 4; ++stage) {
    boundary_values_[stage].evaluate(state_.boundaries,
                                     state_.clock.time + stage_time[stage] * time_step);
  }
  prepare_relaxation();
}

// (RP.71), to the time of the state that each stage leaves behind.
template <class T, int D>
void Step<T, D>::prepare_relaxation() {
  constexpr std::array<double, 4> reached = {0.5, 0.5, 1, 1};
  for (int stage = 0; stage < 4; ++stage) {
    relaxation_[stage].resize(state_.bodies.size());
    for (std::size_t b = 0; b < state_.bodies.size(); ++b) {
      const Body<T, D>& body = state_.bodies[b];
      auto& terms = relaxation_[stage][b];
      terms.resize(body.prony.size());
      for (std::size_t i = 0; i < terms.size(); ++i) {
        terms[i] = kernels::relaxation<T>(body.prony[i], body.material.bulk_modulus,
                                          reached[stage] * time_step_);
      }
    }
  }
}

template <class T, int D>
void Step<T, D>::fold() {
  result_ = {0, 0, -1};
  failed_block_ = -1;
  strain_rates_.assign(state_.bodies.size(), 0);
  const std::size_t walls = state_.wall_impulse.size();
  for (std::size_t i = 0; i < impulse_.size(); ++i) {
    for (int a = 0; a < D; ++a) state_.wall_impulse[i % walls][a] += impulse_[i][a];
  }
  for (std::size_t b = 0; b < results_.size(); ++b) {
    result_.strain_rate = std::max(result_.strain_rate, results_[b].strain_rate);
    result_.wave_speed = std::max(result_.wave_speed, results_[b].wave_speed);
    double& of_body = strain_rates_[state_.blocks[b].body];
    of_body = std::max(of_body, results_[b].strain_rate);
    if (results_[b].non_finite >= 0 && failed_block_ < 0) {
      result_.non_finite = results_[b].non_finite;
      failed_block_ = static_cast<int>(b);
    }
  }
}

// A body drifts with its images, so that only the drift is copied, never the position.
template <class T, int D>
void Step<T, D>::copy_image_drift(int block, int stage) {
  const auto [body, local] = owner(block);
  for (auto& component : body.stage[buffer_of(stage)][Field::displacement]) {
    for (const auto& [image, source] : body.population.images[local]) {
      component[image] = component[source];
    }
  }
}

template <class T, int D>
void Step<T, D>::copy_images(int block, int stage) {
  const auto [body, local] = owner(block);
  const auto& images = body.population.images[local];
  for (auto& component : body.stage[buffer_of(stage)][Field::velocity]) {
    for (const auto& [image, source] : images) component[image] = component[source];
  }
  for (T* component : body.stress_view(stage % 2)) {
    for (const auto& [image, source] : images) component[image] = component[source];
  }
}

template <class T, int D>
void Step<T, D>::write_records(int block, int stage) {
  const auto [body, local] = owner(block);
  const Layout<D>& layout = body.population.layout;
  const BlockGhosts<T, D>& ghosts = body.population.ghosts[local];
  kernels::SurfaceRecords<T, D> work = {};
  work.segments = layout.segments_of(layout.blocks()[local]);
  work.packs = ghosts.packs.data();
  work.pack_count = static_cast<int>(ghosts.packs.size());
  work.spacing = static_cast<T>(body.lattice.spacing);
  work.material = body.material;
  work.mass = body.stage[0].get(Field::mass);
  work.level_set = body.stage[0].get(Field::level_set);
  work.state = body.stage[buffer_of(stage)].template evolving<const T>();
  work.stress = std::as_const(body).stress_view(stage % 2);
  work.records = body.records.get();
  work.relaxes = !body.prony.empty();
  kernels_.write_surface_records(work);
}

template <class T, int D>
void Step<T, D>::fill_all(int block, int stage) {
  const auto [body, local] = owner(block);
  fill_ghosts<T, D>(body, local, stage, stage % 2, WhichGhosts::all, state_.boundaries,
                    boundary_values_[stage], settings_.ghosts, kernels_);
}

// Ghosts that no stencil reaches only have to come along until the next remeshing. Lists of
// neighbours may hold them too, and want their stress; where they drift to must not depend on that.
template <class T, int D>
void Step<T, D>::fill(int block, int stage) {
  const auto [body, local] = owner(block);
  const WhichGhosts which = body.neighbours.are_listed ? WhichGhosts::all : WhichGhosts::reached;
  fill_ghosts<T, D>(body, local, stage, stage % 2, which, state_.boundaries,
                    boundary_values_[stage], settings_.ghosts, kernels_);
  drift_ghosts<T, D>(body, local, stage, settings_.ghosts, kernels_);
  Point<D>* impulse = impulse_.data() + block * state_.boundaries.walls.size();
  add_impulse<T, D>(body, local, state_.boundaries, boundary_values_[stage],
                    stage_weight[stage] * time_step_, kernels_, impulse);
}

template <class T, int D>
void Step<T, D>::decide_contact(int block, int) {
  const auto [body, local] = owner(block);
  remeshed::decide_contact<T, D>(body, local, state_.boundaries, boundary_values_[0], kernels_);
}

template <class T, int D>
void Step<T, D>::advance(int block, int stage) {
  const auto [body, local] = owner(block);
  const Population<T, D>& population = body.population;
  const Block<D>& range = population.layout.blocks()[local];
  kernels::Stage<T, D> work = {};
  work.segments = population.layout.segments_of(range);
  work.segment_count = range.segment_count;
  work.spacing = static_cast<T>(body.lattice.spacing);
  work.time_step = static_cast<T>(time_step_);
  // At rest: a speed that followed the state would be one step late, or another body's.
  work.dissipation = static_cast<T>(settings_.discretisation.dissipation) *
                     kernels::wave_speed_at_rest(body.material) / (16 * work.spacing);
  work.stage = stage;
  work.weight = settings_.discretisation.weight;
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
  results_[block] = kernels_.advance_stage(work);
}

template <class T, int D>
void Step<T, D>::evaluate_stress(int block) {
  const auto [body, local] = owner(block);
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
  results_[block] = kernels_.evaluate_stress(work);
}

template class Step<double, 2>;
template class Step<double, 3>;

}  // namespace pliant::remeshed

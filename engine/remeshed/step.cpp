#include "engine/remeshed/step.hpp"

#include <algorithm>

#include "engine/remeshed/contact/wall_contact.hpp"
#include "engine/remeshed/ghosts/surface_records.hpp"
#include "engine/remeshed/images.hpp"
#include "engine/remeshed/pair_stress.hpp"
#include "engine/remeshed/resources.hpp"
#include "engine/remeshed/runge_kutta.hpp"
#include "engine/remeshed/setup.hpp"

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
Step<T, D>::Step(State<T, D>& state, const Case& settings,
                 const kernels::RemeshedTable<T, D>& kernels)
    : state_(state),
      settings_(settings),
      kernels_(kernels),
      particles_(state, settings, kernels),
      contact_(state, settings, kernels),
      momentum_(state, settings) {}

template <class T, int D>
std::vector<Phase> Step<T, D>::phases() {
  results_.assign(state_.blocks.size(), {0, 0, -1});
  std::vector<Phase> phases;
  for (int stage = 0; stage < 4; ++stage) {
    is_plain_sph(settings_) ? add_pair_stress(phases, stage)
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
  std::vector<Phase> phases = {
      {.name = "stress",
       .reads = {{resource::material(0)}},
       .writes = {{resource::stress(0)}},
       .run = [this](int block) { results_[block] = particles_.evaluate_stress(block); }}};
  if (momentum_.is_needed()) momentum_.add_phases(phases, {});
  return phases;
}

template <class T, int D>
template <class F>
Phase Step<T, D>::on_blocks(const char* name, int stage, const Accesses& reads,
                            const Accesses& writes, F run) {
  return {.name = name,
          .stage = stage,
          .reads = reads,
          .writes = writes,
          .run = [this, run](int block) {
            const auto [body, local] = state_.owner(block);
            run(body, local);
          }};
}

template <class T, int D>
void Step<T, D>::add_ghosts(std::vector<Phase>& phases, int stage, WhichGhosts which) {
  using Body = remeshed::Body<T, D>;
  const int parity = stage % 2, buffer = buffer_of(stage);
  if (periodic()) {
    phases.push_back(
        on_blocks("image positions", stage, {{resource::drift(buffer), Reach::neighbours}},
                  {{resource::image_drift(buffer)}},
                  [stage](Body& body, int block) { copy_image_drift(body, block, stage); }));
  }
  phases.push_back(on_blocks("surface", stage,
                             {{resource::drift(buffer), Reach::neighbours},
                              {resource::image_drift(buffer)},
                              {resource::velocity(buffer)},
                              {resource::stress(parity)},
                              {resource::material(buffer)}},
                             {{resource::records}}, [this, stage](Body& body, int block) {
                               write_surface_records(body, block, stage, kernels_);
                             }));
  if (stage == 0 && state_.boundaries.have_contact()) {
    phases.push_back(on_blocks(
        "contact", stage, {{resource::records, Reach::neighbours}, {resource::drift(buffer)}},
        {{resource::contact}}, [this](Body& body, int block) {
          decide_contact(body, block, state_.boundaries, boundary_values_[0], kernels_);
        }));
  }
  if (contact_.is_needed()) {
    if (stage == 0) contact_.add_search(phases);
    contact_.add_tractions(phases, stage);
  }
  add_filling(phases, stage, which);
  if (periodic()) {
    phases.push_back(on_blocks("images", stage,
                               {{resource::velocity(buffer), Reach::neighbours},
                                {resource::stress(parity), Reach::neighbours},
                                {resource::ghosts(buffer), Reach::neighbours}},
                               {{resource::images(buffer)}}, [stage](Body& body, int block) {
                                 copy_images(body, block, stage);
                               }));
  }
}

template <class T, int D>
void Step<T, D>::add_filling(std::vector<Phase>& phases, int stage, WhichGhosts which) {
  const int buffer = buffer_of(stage);
  Accesses reads = {{resource::records, Reach::neighbours},
                    {resource::tractions},
                    {resource::drift(buffer), Reach::neighbours},
                    {resource::velocity(buffer), Reach::neighbours}};
  Accesses writes = {{resource::ghosts(buffer)}};
  if (state_.boundaries.have_contact()) {
    writes.insert(writes.end(), {{resource::contact}, {resource::impulse}});
  }
  const bool drifts = which == WhichGhosts::reached;
  if (drifts && stage == 2) {
    reads.insert(reads.end(), {{resource::ghosts(0)}, {resource::ghosts(1)}});
  }
  if (drifts && stage == 3) reads.push_back({resource::ghosts(2)});
  phases.push_back({.name = "ghosts",
                    .stage = stage,
                    .reads = std::move(reads),
                    .writes = std::move(writes),
                    .run = [this, stage, drifts](int block) {
                      drifts ? fill(block, stage) : fill_all(block, stage);
                    }});
}

template <class T, int D>
void Step<T, D>::add_pair_stress(std::vector<Phase>& phases, int stage) {
  phases.push_back(on_blocks(
      "pair stress", stage, {{resource::stress(stage % 2)}, {resource::material(buffer_of(stage))}},
      {{resource::pair_stress}}, [this, stage](Body<T, D>& body, int block) {
        find_pair_stress<T, D>(body, block, stage, settings_.discretisation.artificial_stress);
      }));
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
  const std::vector<int> listed = blocks_where(true);
  if (listed.empty()) return add_advance(phases, stage, Reach::neighbours, {});
  const std::vector<int> others = blocks_where(false);
  if (others.empty()) return add_advance(phases, stage, Reach::all, {});
  add_advance(phases, stage, Reach::neighbours, others);
  add_advance(phases, stage, Reach::all, listed);
}

template <class T, int D>
void Step<T, D>::add_advance(std::vector<Phase>& phases, int stage, Reach reach,
                             const std::vector<int>& blocks) {
  const int parity = stage % 2, current = buffer_of(stage), next = buffer_after(stage);
  Accesses reads = {{resource::drift(current), reach},
                    {resource::velocity(current), reach},
                    {resource::stress(parity), reach},
                    {resource::ghosts(current), reach},
                    {resource::images(current), Reach::neighbours},
                    {resource::material(current)}};
  if (is_plain_sph(settings_)) {
    reads.insert(reads.end(),
                 {{resource::pair_stress, reach}, {resource::material(current), reach}});
  }
  Accesses writes = {{resource::stress(1 - parity)},
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
  phases.push_back(
      {.name = "advance",
       .stage = stage,
       .reads = std::move(reads),
       .writes = std::move(writes),
       .blocks = blocks,
       .run = [this, stage](int block) { results_[block] = particles_.advance(block, stage); }});
}

template <class T, int D>
bool Step<T, D>::periodic() const {
  return std::any_of(state_.bodies.begin(), state_.bodies.end(),
                     [](const Body<T, D>& body) { return body.lattice.is_periodic(); });
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
  particles_.prepare(time_step);
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

template <class T, int D>
void Step<T, D>::fill_all(int block, int stage) {
  const auto [body, local] = state_.owner(block);
  fill_ghosts<T, D>(body, local, stage, stage % 2, WhichGhosts::all, state_.boundaries,
                    boundary_values_[stage], settings_.ghosts, kernels_);
}

// Ghosts that no stencil reaches only have to come along until the next remeshing. Lists of
// neighbours may hold them too, and want their stress; where they drift to must not depend on that.
template <class T, int D>
void Step<T, D>::fill(int block, int stage) {
  const auto [body, local] = state_.owner(block);
  const WhichGhosts which = body.neighbours.are_listed ? WhichGhosts::all : WhichGhosts::reached;
  fill_ghosts<T, D>(body, local, stage, stage % 2, which, state_.boundaries,
                    boundary_values_[stage], settings_.ghosts, kernels_);
  drift_ghosts<T, D>(body, local, stage, settings_.ghosts, kernels_);
  Point<D>* impulse = impulse_.data() + block * state_.boundaries.walls.size();
  add_impulse<T, D>(body, local, state_.boundaries, boundary_values_[stage],
                    stage_weight[stage] * time_step_, kernels_, impulse);
}

template class Step<double, 2>;
template class Step<double, 3>;
template class Step<float, 2>;
template class Step<float, 3>;

}  // namespace pliant::remeshed

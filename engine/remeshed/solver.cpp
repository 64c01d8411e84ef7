#include "engine/remeshed/solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "engine/case/checks/stability.hpp"
#include "engine/method/step_length.hpp"
#include "engine/remeshed/observe/field_views.hpp"
#include "engine/remeshed/observe/frame.hpp"
#include "engine/remeshed/remeshing/moving_lattice.hpp"
#include "engine/remeshed/remeshing/remeshing_due.hpp"
#include "engine/remeshed/setup/setup.hpp"
#include "engine/remeshed/state/check_state.hpp"
#include "engine/remeshed/state/resources.hpp"
#include "engine/remeshed/state/state_archive.hpp"

namespace pliant::remeshed {

namespace {

std::vector<std::string> remedies(const Case& settings) {
  using Policy = decltype(Case::remeshing)::Policy;
  const bool adaptive = settings.remeshing.policy == Policy::adaptive;
  return {smaller_step(settings),
          adaptive
              ? "remesh more often (remeshing.strain_threshold, remeshing.deformation_threshold)"
              : "remesh more often (remeshing.every)",
          "use a finer spacing"};
}

}  // namespace

template <class T, int D>
Solver<T, D>::Solver(const Case& a_case, const SolverOptions& options)
    : pliant::Solver(a_case, options),
      kernels_(kernels::RemeshedTable<T, D>::of(options.isa)),
      state_(make_state<T, D>(settings())),
      step_(state_, settings(), kernels_),
      remeshings_(settings(), state_, kernels_, workers(), Outside::ghosts),
      search_(state_, settings().discretisation.kernel),
      step_graph_(resource::names()),
      listed_step_graph_(resource::names()),
      search_graph_(resource::names()),
      ghost_graph_(resource::names()),
      source_graph_(resource::names()),
      target_graph_(resource::names()),
      stress_graph_(resource::names()),
      listed_(state_.bodies.size()),
      slowing_(std::sqrt(step_limits(settings()).mass_scaling)) {
  remeshings_.place_initial();
  number_blocks<D>(remeshings_.layouts(), state_.blocks);
  step_.momentum().open();
  use_new_slots();
  state_.clock.strain_rate = bound_of_initial_strain_rate();
}

// Maximum of abs(grad u)_F, from differences along lattice lines.
template <class T, int D>
double Solver<T, D>::bound_of_initial_strain_rate() {
  double largest = 0;
  for (Body<T, D>& body : state_.bodies) {
    const Layout<D>& layout = body.population.layout;
    for (const Block<D>& block : layout.blocks()) {
      largest = std::max(
          largest, kernels_.lattice_gradient(
                       {layout.segments_of(block), block.segment_count,
                        static_cast<T>(body.lattice.spacing), body.population.pack_state.get(),
                        body.interior.get(), body.stage[0].template evolving<const T>().velocity}));
    }
  }
  return largest;
}

template <class T, int D>
double Solver<T, D>::time_step() const {
  return asked_step(settings(), state_.clock.wave_speed / slowing_, state_.clock.strain_rate);
}

template <class T, int D>
void Solver<T, D>::take_step(double dt) {
  move(dt);
  add_particle_stages(4 * particles());
  if (remeshing_is_due<T, D>(settings(), state_)) remesh();
}

template <class T, int D>
void Solver<T, D>::look_ahead(double time, const std::function<void()>& look) {
  before_look_.keep(state_);
  move(time - state_.clock.time);
  look();
  before_look_.put_back(state_);
  measurer_.reset();
}

template <class T, int D>
void Solver<T, D>::move(double dt) {
  Clock& clock = state_.clock;
  measurer_.reset();
  step_.prepare(dt);
  find_neighbours(dt);
  run(*present_graph_);
  step_.fold();
  step_.follow_motion(dt);
  check_finite(settings(), step_.results(), state_, remedies);
  check_strain(settings(), step_.results(), state_, dt, remedies);
  for (Wall<D>& wall : state_.boundaries.walls) wall.move(clock.time, dt);
  clock.time += dt;
  ++clock.step;
  ++clock.steps_since_remeshing;
  ++clock.steps_since_reinitialisation;
  clock.accumulated_strain += dt * step_.results().total().strain_rate;
  clock.deformation = step_.results().total().deformation;
  clock.strain_rate = step_.results().total().strain_rate;
  clock.wave_speed = slowing_ * step_.results().total().wave_speed;
  search_.add_strain(step_.results(), dt);
}

template <class T, int D>
void Solver<T, D>::remesh() {
  Clock& clock = state_.clock;
  const bool reinitialise =
      clock.steps_since_reinitialisation >= settings().level_set.reinitialise_every;
  move_lattices<T, D>(state_);
  remesh_onto_spare(reinitialise, true);
  if (reinitialise) clock.steps_since_reinitialisation = 0;
  ++clock.remeshings;
  clock.steps_since_remeshing = 0;
  clock.accumulated_strain = 0;
  clock.deformation = 0;
  for (Body<T, D>& body : state_.bodies) body.neighbours.strain = 0;
  remeshings_.commit();
  std::ranges::transform(state_.boundaries.walls, state_.remeshed_poses.begin(), &Wall<D>::pose);
  measurer_.reset();
  use_new_slots();
}

template <class T, int D>
void Solver<T, D>::remesh_onto_spare(bool reinitialise, bool is_final) {
  step_.prepare(0);
  run(source_graph_.over(remeshings_.layouts(), [&] { return source_phases(); }));
  check_layouts();
  remeshings_.prepare_target(reinitialise, is_final);
  run(target_graph_.over(remeshings_.new_layouts(),
                         [&] { return remeshings_.target_phases(true); }));
}

template <class T, int D>
std::vector<scheduler::Phase> Solver<T, D>::source_phases() {
  std::vector<scheduler::Phase> phases = step_.ghost_phases();
  std::ranges::move(remeshings_.source_phases(), std::back_inserter(phases));
  return phases;
}

template <class T, int D>
void Solver<T, D>::use_new_slots() {
  check_bodies(settings(), state_, remedies);
  number_slots();
  run(stress_graph_.over(remeshings_.layouts(), [&] { return step_.stress_phases(); }));
  step_.fold();
  check_finite(settings(), step_.results(), state_, remedies);
  state_.clock.wave_speed = slowing_ * step_.results().total().wave_speed;
}

template <class T, int D>
void Solver<T, D>::number_slots() {
  number_blocks<D>(remeshings_.layouts(), state_.blocks);
  search_.clear();
  present_graph_ = &step_graph_.over(remeshings_.layouts(), [&] { return step_.phases(); });
}

// The step over neighbour lists has a graph of its own. Both graphs are kept, since bodies that
// strain much between remeshings switch from one to the other and back.
template <class T, int D>
void Solver<T, D>::find_neighbours(double time_step) {
  if (!search_.is_due(time_step)) return;
  run(search_graph_.over(remeshings_.layouts(), [&] { return search_.phases(); }));
  const auto is_listed = [](const Body<T, D>& body) { return body.neighbours.are_listed; };
  if (std::none_of(state_.bodies.begin(), state_.bodies.end(), is_listed)) return;
  for (std::size_t b = 0; b < state_.bodies.size(); ++b) {
    if (listed_[b] == is_listed(state_.bodies[b])) continue;
    listed_[b] = !listed_[b];
    listed_step_graph_.drop();
  }
  present_graph_ = &listed_step_graph_.over(remeshings_.layouts(), [&] { return step_.phases(); });
}

template <class T, int D>
void Solver<T, D>::check_layouts() {
  for (std::size_t b = 0; b < state_.bodies.size(); ++b) {
    if (remeshings_[b].has_layout()) continue;
    throw failed_step(settings(), state_.clock,
                      fmt::format("the particles of body `{}` have flown too far apart for one "
                                  "lattice",
                                  state_.bodies[b].name),
                      remedies(settings()));
  }
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
  const bool fresh = lies_on_nodes();
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
  run(ghost_graph_.over(remeshings_.layouts(), [&] { return step_.ghost_phases(); }));
}

template <class T, int D>
Measurer<T, D>& Solver<T, D>::measurer() {
  if (!measurer_) measurer_.emplace(settings(), state_, workers(), [this] { return on_nodes(); });
  return *measurer_;
}

template <class T, int D>
std::vector<double> Solver<T, D>::measure_each(std::span<const MeasurementCase> measurements) {
  return measurer()(measurements);
}

template <class T, int D>
BodyIntegrals Solver<T, D>::integrals() {
  return measurer().totals();
}

template <class T, int D>
Frame Solver<T, D>::frame(const FrameParts& parts) {
  if (parts.ghosts) refresh_ghosts();
  return take_frame<T, D>(
      state_, kernels_, [this] { return measurer().nodes(); },
      [this] { return step_.surroundings(); }, parts);
}

template <class T, int D>
std::vector<SlotRun> Solver<T, D>::particle_runs(int body) const {
  return slot_runs(state_.bodies.at(body));
}

template <class T, int D>
std::vector<FieldView> Solver<T, D>::fields(int body) const {
  return field_views(state_.bodies.at(body));
}

template <class T, int D>
std::vector<std::array<double, 3>> Solver<T, D>::positions(int body) const {
  return present_positions(state_.bodies.at(body));
}

template <class T, int D>
void Solver<T, D>::save_state(ArchiveWriter& archive) const {
  put_state(archive, state_);
}

template <class T, int D>
void Solver<T, D>::restore_state(const ArchiveReader& archive) {
  measurer_.reset();
  get_state(archive, state_, remeshings_);
  number_slots();
}

template class Solver<double, 2>;
template class Solver<double, 3>;
template class Solver<float, 2>;
template class Solver<float, 3>;

}  // namespace pliant::remeshed

#include "engine/point_based/step.hpp"

#include <algorithm>

#include "engine/method/phase_rows.hpp"
#include "engine/point_based/block_arguments.hpp"
#include "engine/point_based/forces/degenerate_nodes.hpp"
#include "engine/point_based/parameters.hpp"
#include "engine/point_based/surface/contact_surface.hpp"

// A step of the point-based method. All work is on the bonds of the undeformed body.
//
//     cuts      bonds that blades have changed, and gradients that nodes have kept (PB.14)
//     drift     displacement at the time of the kick: half a step on for the leapfrog (PB.10)
//     loads     forces of pressures (PB.11), tractions and gravity (PB.15) on each node
//     forces    F at each node from its neighbours, the stress, and its force along the bonds
//               (PB.4)-(PB.9), collected for own nodes and for those of other blocks
//     motion    the force on each node; velocity and displacement (PB.10); the velocity that walls
//               prescribe, and the work of walls and loads
//     cut faces, punctures, contact walls
//               pushes back nodes that have passed the opposite face of a cut, surfaces that a
//               blade touches before it enters, and nodes inside a wall (PB.20), (PB.34), (TL.12)
//     contact: ...
//               from time to time, facets near corners; where these corners and facets are;
//               corners that have entered another body (TL.15); impulses between the bodies, in
//               sweeps on one thread (TL.16)
//     work      work of loads and gravity, after contact has changed velocities; without contact,
//               part of `motion`
//
// A block sums the forces on its nodes in the order of the blocks that collected them, so that the
// sums do not depend on the number of threads.
namespace pliant::point_based {

using scheduler::Phase;
using enum Group;

template <class T, int D>
Step<T, D>::Step(State<T, D>& state, const Case& settings,
                 const kernels::PointBasedTable<T, D>& kernels)
    : state_(state),
      settings_(settings),
      kernels_(kernels),
      loads_(state, settings),
      work_(state),
      contact_(state, settings, &Body<T, D>::displacement),
      body_contact_(state, settings, &Body<T, D>::displacement) {}

template <class T, int D>
double Step<T, D>::drift_length() const {
  return is_leapfrog(settings_) ? advance_.length / 2 : advance_.length;
}

template <class T, int D>
void Step<T, D>::prepare_blocks() {
  results_.assign(state_.blocks.size(), {});
  sampler_.prepare_blocks(state_.blocks.size());
  memory_.clear();
  for (const Body<T, D>& body : state_.bodies) memory_.emplace_back(body);
  work_.clear_blocks();
  for (const Body<T, D>& body : state_.bodies) work_.add_blocks(body);
  body_contact_.take_surfaces(state_.bodies);
  contact_.take_surfaces(state_.bodies, undeformed::ImpulseCarriers::first);
}

template <class T, int D>
std::vector<Phase> Step<T, D>::phases() {
  prepare_blocks();
  const auto run = [this](auto function) {
    return [this, function](int block) { (this->*function)(block); };
  };
  std::vector<Phase> phases;
  PhaseRows rows(phases);
  const auto& cuts = state_.cuts;
  if (std::any_of(cuts.begin(), cuts.end(), [](const auto& of_body) { return !!of_body; })) {
    rows.each("cuts", near(of(displacement) + of(mass)) + own(of(constants)),
              own(of(constants) + of(results)), run(&Step::cut));
  }
  if (is_leapfrog(settings_)) {
    rows.each("drift", own(of(velocity) + of(displacement)), own(of(displacement)),
              run(&Step::drift));
  }
  if (loads_.act_on_blocks()) {
    rows.each("loads", near(of(displacement)) + own(of(mass) + of(constants)), own(of(loads)),
              run(&Step::load));
  }
  rows.each("forces",
            near(of(displacement)) + own(of(mass) + of(constants) + of(loads) + of(strain)),
            own(of(own_forces) + of(halo_forces) + of(strain) + of(results)),
            run(&Step::evaluate_forces));
  rows.each("motion",
            near(of(halo_forces)) + own(of(own_forces) + of(mass) + of(constants) + of(loads) +
                                        of(velocity) + of(displacement)),
            own(of(own_forces) + of(velocity) + of(displacement) + of(results)), run(&Step::move));
  const Resources motion = of(displacement) + of(velocity), held = of(constants) + of(mass);
  if (has_faces()) {
    rows.reduce("cut faces", all(motion + held), all(motion), [this] { push_faces_apart(); });
  }
  if (has_punctures()) {
    rows.reduce("punctures", all(motion + held), all(motion), [this] { press_surfaces(); });
  }
  add_contact(rows, {motion, held, of(contact_lists), of(contact_places), of(contact_normals),
                     of(touches)});
  if (bodies_touch()) {
    rows.each("work", own(of(velocity) + of(mass) + of(constants) + of(loads) + of(own_forces)),
              own(of(own_forces) + of(results)), run(&Step::end_motion));
  }
  return phases;
}

template <class T, int D>
void Step<T, D>::add_contact(PhaseRows& rows, const undeformed::ContactFields& fields) {
  if (contact_.is_expected()) {
    rows.reduce("contact walls", all(fields.motion + fields.constants), all(fields.motion),
                [this] { meet_walls(); });
  }
  body_contact_.add_phases(rows, fields);
}

template <class T, int D>
bool Step<T, D>::has_faces() const {
  return std::any_of(state_.cuts.begin(), state_.cuts.end(),
                     [](const auto& of_body) { return of_body && of_body->faces_meet(); });
}

template <class T, int D>
void Step<T, D>::push_faces_apart() {
  for (std::size_t b = 0; b < state_.cuts.size(); ++b) {
    if (!state_.cuts[b]) continue;
    state_.cuts[b]->push_faces_apart(state_.bodies[b], advance_.length, drift_length());
  }
}

template <class T, int D>
bool Step<T, D>::has_punctures() const {
  return std::any_of(state_.cuts.begin(), state_.cuts.end(),
                     [](const auto& of_body) { return of_body && of_body->has_punctures(); });
}

template <class T, int D>
void Step<T, D>::press_surfaces() {
  const double inertia = state_.clock.inertia(advance_.length);
  for (std::size_t b = 0; b < state_.cuts.size(); ++b) {
    if (!state_.cuts[b]) continue;
    const double power = state_.cuts[b]->press_surface(
        state_.bodies[b], advance_.time, {advance_.length, drift_length(), inertia}, state_.blades);
    state_.energy.blade_work += advance_.length * power;
    state_.power.blade_work += power;
  }
}

template <class T, int D>
void Step<T, D>::prepare(const Advance& advance) {
  advance_ = advance;
  cuts_have_moved_ = false;
  for (const auto& of_body : state_.cuts) {
    if (of_body) cuts_have_moved_ = of_body->move(advance.time) || cuts_have_moved_;
  }
  for (BladeLoad<D>& blade : state_.blades) blade.force = {}, blade.power = 0;
  for (std::size_t b = 0; b < state_.cuts.size(); ++b) {
    if (!state_.cuts[b]) continue;
    state_.cuts[b]->load(advance.time, advance.length, state_.bodies[b], state_.blades);
  }
  const double since = is_leapfrog(settings_) ? advance.kick() : advance.previous;
  for (std::size_t b = 0; b < memory_.size(); ++b) memory_[b].prepare(since, state_.bodies[b]);
  const double middle = advance.time + advance.length / 2;
  loads_.prepare(is_leapfrog(settings_) ? middle : advance.time);
  work_.prepare({advance.time, advance.length, advance.length, drift_length()});
  body_contact_.prepare(advance.length, advance.length, drift_length());
}

template <class T, int D>
void Step<T, D>::meet_walls() {
  contact_.apply(advance_.time, advance_.length, advance_.length, drift_length());
}

// Walls that hold bodies are seldom met by other parts of them, which is not worth a phase.
template <class T, int D>
void Step<T, D>::meet_attached_walls() {
  meet_walls();
  const auto first_slot = [this](const BlockOwner& owner) {
    return state_.bodies[owner.body].blocks[owner.block].first;
  };
  for (const int block : undeformed::blocks_of(contact_.pushed(), state_.blocks, first_slot)) {
    add_work_after_contact(block);
  }
}

template <class T, int D>
StepResult Step<T, D>::fold() {
  if (!contact_.is_expected()) meet_attached_walls();
  StepResult result;
  for (std::size_t b = 0; b < results_.size() && result.non_finite < 0; ++b) {
    result.non_finite = results_[b].forces.non_finite;
    result.failed_block = static_cast<int>(b);
    result.frequency2 = std::max(result.frequency2, results_[b].forces.frequency2);
    // Nodes whose velocities change sign from step to step lose little, (TL.28).
    const kernels::PointMotionSums& motion = results_[b].motion;
    work_.fold(static_cast<int>(b), motion.inertia, motion.inertia_of_means);
  }
  if (advance_.samples) result.secant = sampler_.secant();
  for (const auto& of_body : state_.cuts) {
    if (of_body) state_.energy.cut_work += of_body->fold();
  }
  for (BladeLoad<D>& blade : state_.blades) {
    for (int a = 0; a < D; ++a) blade.impulse[a] += advance_.length * blade.force[a];
    blade.work += advance_.length * blade.power;
  }
  result.overlap = body_contact_.deepest();
  return result;
}

template <class T, int D>
void Step<T, D>::cut(int block) {
  const BlockOwner& owner = state_.blocks[block];
  const auto& cuts = state_.cuts[owner.body];
  if (cuts) cuts->update(owner.block, state_.bodies[owner.body]);
}

template <class T, int D>
void Step<T, D>::drift(int block) {
  const auto [body, local] = owner(block);
  auto arguments = drift_arguments(body, local);
  arguments.drift = static_cast<T>(advance_.length / 2);
  kernels_.drift(arguments);
}

template <class T, int D>
void Step<T, D>::evaluate_forces(int block) {
  const auto [body, local] = owner(block);
  auto arguments = force_arguments(body, local);
  arguments.viscosity =
      static_cast<T>(parameters_of(settings_).stiffness_damping / advance_.length);
  arguments.examine = advance_.examine || cuts_have_moved_;
  const undeformed::BodyMemory<T>& memory = memory_[state_.blocks[block].body];
  arguments.networks = memory.shear.networks();
  arguments.bulk = memory.bulk.relaxation();
  const auto& cuts = state_.cuts[state_.blocks[block].body];
  if (cuts && !cuts->keeps_gradients(local)) arguments.kept = {};
  results_[block].forces = kernels_.evaluate_forces(arguments);
  if (!body.degenerate[local].empty()) add_degenerate_forces(body, local);
}

template <class T, int D>
void Step<T, D>::move(int block) {
  const auto [body, local] = owner(block);
  auto arguments = motion_arguments(body, local);
  const undeformed::Kick<T> of_step = kick();
  arguments.kept = of_step.kept;
  arguments.gained = of_step.gained;
  arguments.drift = static_cast<T>(drift_length());
  for (int a = 0; a < D; ++a) {
    arguments.gravity[a] = static_cast<T>(loads_.uniform_gravity()[a]);
  }
  if (state_.clock.damping > 0) arguments.mass = body.mass.get();
  work_.begin_motion(block, body, local, power(block));
  const NodeBlock& range = body.blocks[local];
  if (advance_.samples) sampler_.begin(block, body, range.first, range.nodes);
  results_[block].motion = kernels_.advance(arguments);
  work_.hold(block, body, local);
  if (!bodies_touch()) end_motion(block);
}

template <class T, int D>
void Step<T, D>::end_motion(int block) {
  if (advance_.samples) sampler_.end(block, owner(block).body, kick());
  if (bodies_touch()) {
    add_work_after_contact(block);
  } else {
    work_.end_motion(block, power(block));
  }
}

template <class T, int D>
void Step<T, D>::add_work_after_contact(int block) {
  const auto [body, local] = owner(block);
  const NodeBlock& range = body.blocks[local];
  work_.after_contact(block, body, range.first, range.nodes);
  work_.end_motion(block, power(block));
}

template <class T, int D>
EnergyBudget Step<T, D>::power(int block) const {
  EnergyBudget power = loads_.power(block);
  const Point<D>& gravity = loads_.uniform_gravity();
  if (gravity == Point<D>{}) return power;
  const auto [body, local] = owner(block);
  const auto momentum = kernels_.momentum(momentum_arguments(body, local));
  for (int a = 0; a < D; ++a) power.body_force_work += momentum[a] * gravity[a];
  return power;
}

template class Step<double, 2>;
template class Step<double, 3>;
template class Step<float, 2>;
template class Step<float, 3>;

}  // namespace pliant::point_based

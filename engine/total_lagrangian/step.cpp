#include "engine/total_lagrangian/step.hpp"

#include <algorithm>

#include "engine/method/hyperelastic.hpp"
#include "engine/method/phase_rows.hpp"
#include "engine/total_lagrangian/contact_surface.hpp"
#include "engine/total_lagrangian/parameters.hpp"

// A step of the total Lagrangian method. All work is on the lattice of the undeformed body, where
// particles always have the same neighbours.
//
//     pressure          the force on the surface inside each cell where a load acts (TL.7)
//     traction          gravity on each particle, and its share of the force on the surface
//     motion            F at the stress points around the particles, from the particles at the
//                       corners of their cells, the stress, and its force on those corners
//                       (TL.2)-(TL.6); velocity and displacement by central differences with
//                       damping (TL.8); the velocity that walls prescribe
//     contact walls     corners of the surface that have entered one are pushed back (TL.12)
//     contact: ...      from time to time, facets near corners; where these corners and facets
//                       are; corners that have entered another body (TL.15); impulses between
//                       the bodies, in sweeps on one thread (TL.16)
//     work              work of loads and gravity, after contact has changed velocities; without
//                       contact, part of `motion`
//
// Forces stay in the cache: a block evaluates every cell that has one of its particles as a corner,
// so cells between blocks are evaluated several times. Blocks still read displacements of the start
// of the step, so displacements of its end, and the memory of a viscous material, go to separate
// arrays. These are then swapped.
//
// The stress is evaluated once a step, and the state is displacement and velocity alone: F depends
// only on where the particles are, so that nothing creeps under a constant load.
namespace pliant::total_lagrangian {

using scheduler::Phase;
using enum Group;

template <class T, int D>
Step<T, D>::Step(State<T, D>& state, const Case& settings,
                 const kernels::TotalLagrangianTable<T, D>& kernels, scheduler::Workers& workers)
    : state_(state),
      settings_(settings),
      kernels_(kernels),
      boundary_forces_(state, settings),
      contact_(state, settings, &Body<T, D>::end_displacement),
      body_contact_(state, settings, &Body<T, D>::end_displacement),
      workers_(workers) {}

template <class T, int D>
std::vector<Phase> Step<T, D>::phases() {
  results_.assign(state_.blocks.size(), {});
  sampler_.prepare_blocks(state_.blocks.size());
  boundary_forces_.prepare_blocks();
  body_contact_.take_surfaces(state_.bodies);
  contact_.take_surfaces(state_.bodies, undeformed::ImpulseCarriers::all);
  reserve_forces();
  memory_.clear();
  for (const Body<T, D>& body : state_.bodies) memory_.emplace_back(body);
  std::vector<Phase> phases;
  PhaseRows rows(phases);
  if (!state_.boundaries.pressures.empty()) {
    rows.each("pressure", near(of(displacement)) + own(of(surface)), own(of(patch_forces)),
              [this](int block) { boundary_forces_.sum_patch_loads(block); });
  }
  if (boundary_forces_.act_on_particles()) {
    rows.each("traction",
              near(of(patch_forces)) + own(of(surface) + of(constants) + of(displacement)),
              own(of(tractions)), [this](int block) { boundary_forces_.distribute(block); });
  }
  rows.each("motion",
            near(of(displacement) + of(memory) + of(constants) + of(patch_forces)) +
                own(of(tractions) + of(surface) + of(internal_forces) + of(velocity) + of(next)),
            own(of(internal_forces) + of(velocity) + of(next) + of(results)),
            [this](int block) { move(block); });
  const Resources motion = of(next) + of(velocity) + of(internal_forces),
                  held = of(constants) + of(surface);
  if (contact_.is_expected()) {
    rows.reduce("contact walls", all(motion + held), all(motion), [this] { meet_walls(); });
  }
  body_contact_.add_phases(rows, {motion, held, of(contact_lists), of(contact_places),
                                  of(contact_normals), of(touches)});
  if (bodies_touch()) {
    rows.each(
        "work",
        near(of(patch_forces)) + own(of(velocity) + of(tractions) + of(internal_forces) + held),
        own(of(internal_forces) + of(results)), [this](int block) { end_motion(block); });
  }
  return phases;
}

// Each worker works on one block at a time and needs the forces of only that block.
template <class T, int D>
void Step<T, D>::reserve_forces() {
  std::int64_t slots = 0;
  for (const Body<T, D>& body : state_.bodies) {
    for (const Block<D>& block : body.layout.blocks()) slots = std::max(slots, block.slot_count);
  }
  force_.resize(workers_.threads());
  for (std::array<Buffer<T>, D>& force : force_) {
    for (Buffer<T>& component : force) component.grow(slots, T(0));
  }
}

template <class T, int D>
void Step<T, D>::prepare(const Advance& advance) {
  advance_ = advance;
  boundary_forces_.prepare(advance.time, advance.kick(), advance.length);
  body_contact_.prepare(advance.kick(), advance.length, advance.length);
  for (std::size_t b = 0; b < state_.bodies.size(); ++b) {
    Body<T, D>& body = state_.bodies[b];
    memory_[b].shear.prepare(advance.previous, body.network, body.next_network);
    memory_[b].bulk.prepare(advance.previous, body.material.polynomial.bulk_modulus,
                            {body.memory_pressure, body.volume_change},
                            {body.next_memory_pressure, body.next_volume_change});
  }
}

template <class T, int D>
void Step<T, D>::meet_walls() {
  contact_.apply(advance_.time, advance_.kick(), advance_.length, advance_.length);
}

// Walls that hold bodies are seldom met by other parts of them, which is not worth a phase.
template <class T, int D>
void Step<T, D>::meet_attached_walls() {
  meet_walls();
  const auto first_slot = [this](const BlockOwner& owner) {
    return state_.bodies[owner.body].layout.blocks()[owner.block].first_slot;
  };
  for (const int block : undeformed::blocks_of(contact_.pushed(), state_.blocks, first_slot)) {
    boundary_forces_.end_motion_after_contact(block);
  }
}

template <class T, int D>
StepResult Step<T, D>::fold() {
  if (!contact_.is_expected()) meet_attached_walls();
  for (Body<T, D>& body : state_.bodies) body.take_next();
  StepResult result;
  for (std::size_t b = 0; b < results_.size(); ++b) {
    result.wave_speed = std::max(result.wave_speed, results_[b].wave_speed);
    boundary_forces_.fold(static_cast<int>(b), results_[b].inertia, results_[b].damped);
    if (results_[b].non_finite >= 0 && result.non_finite < 0) {
      result.non_finite = results_[b].non_finite;
      result.failed_block = static_cast<int>(b);
    }
  }
  if (advance_.samples) result.secant = sampler_.secant();
  result.overlap = body_contact_.deepest();
  return result;
}

template <class T, int D>
void Step<T, D>::set_cells(const Body<T, D>& body, int local, kernels::Motion<T, D>& work) const {
  const BlockCells<T, D>& cells = body.cells[local];
  work.runs = cells.runs.data();
  work.run_count = static_cast<int>(cells.runs.size());
  work.fitted = cells.fitted.data();
  work.fitted_count = static_cast<int>(cells.fitted.size());
  work.spacing = static_cast<T>(body.lattice.spacing);
  const kernels::HourglassStiffness<double>& hourglass = body.hourglass;
  work.hourglass = {static_cast<T>(hourglass.modes), static_cast<T>(hourglass.triple),
                    static_cast<T>(hourglass.bending), static_cast<T>(hourglass.saddle)};
  work.examine = advance_.examine;
  work.material = body.material;
  work.fraction = body.regular_fraction.get();
  work.cut = body.cut.data();
  work.cut_packs = body.cut_packs.data();
  for (std::size_t c = 0; c < work.initial_stress.size(); ++c) {
    work.initial_stress[c] = body.initial_stress[c].get();
  }
}

template <class T, int D>
void Step<T, D>::set_particles(Body<T, D>& body, kernels::Motion<T, D>& work) const {
  const undeformed::Kick<T> of_step = kick();
  work.kept = of_step.kept;
  work.gained = of_step.gained;
  work.time_step = static_cast<T>(advance_.length);
  work.damped = state_.clock.damping != 0;
  work.inverse_mass = body.inverse_mass.get();
  for (int a = 0; a < D; ++a) {
    work.displacement[a] = body.displacement[a].get();
    work.next_displacement[a] = body.end_displacement[a].get();
    if (boundary_forces_.act_on_particles()) work.traction[a] = body.traction[a].get();
    work.internal[a] = body.internal[a].get();
    work.velocity[a] = body.velocity[a].get();
  }
}

template <class T, int D>
void Step<T, D>::move(int block) {
  const auto [body, local] = owner(block);
  const Block<D>& range = body.layout.blocks()[local];
  kernels::Motion<T, D> work = {};
  work.first_slot = range.first_slot;
  work.slot_count = range.slot_count;
  set_cells(body, local, work);
  const undeformed::BodyMemory<T>& memory = memory_[state_.blocks[block].body];
  work.bulk = memory.bulk.relaxation();
  work.networks = memory.shear.networks();
  set_particles(body, work);
  std::array<Buffer<T>, D>& force = force_[std::max(workers_.index(), 0)];
  for (int a = 0; a < D; ++a) work.force[a] = force[a].get();
  boundary_forces_.begin_motion(block);
  if (advance_.samples) sampler_.begin(block, body, range.first_slot, range.slot_count);
  results_[block] = kernels_.advance_motion(work);
  boundary_forces_.hold(block);
  if (!bodies_touch()) end_motion(block);
}

template <class T, int D>
void Step<T, D>::end_motion(int block) {
  if (advance_.samples) sampler_.end(block, owner(block).body, kick());
  if (bodies_touch()) {
    boundary_forces_.end_motion_after_contact(block);
  } else {
    boundary_forces_.end_motion(block);
  }
}

template class Step<double, 2>;
template class Step<double, 3>;
template class Step<float, 2>;
template class Step<float, 3>;

}  // namespace pliant::total_lagrangian

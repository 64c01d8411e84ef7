#include "engine/remeshed/step.hpp"

#include <algorithm>

#include "engine/remeshed/ghosts/surface_records.hpp"
#include "engine/remeshed/parameters.hpp"
#include "engine/remeshed/runge_kutta.hpp"
#include "engine/remeshed/state/resources.hpp"

// A step of the remeshed Lagrangian particle method (H&K, sections 2 and 4).
//
// Each of the four stages of the Runge-Kutta method (RP.21) takes a `current` copy of the state
// (Q0, Q2, Q3, and Q4, which uses the memory of Q2) to the `next` one:
//
//     shear             tractions: forces on the particles behind loaded facets, (RP.107)
//     shear stress      the stress that balances these forces, (RP.112)
//     image positions   periodic bodies: drift of the slots beyond a period
//     surface           first stage: grad phi of the particles near the surface (RP.61);
//                       all stages: their u, sigma and p; all of it goes to the surface records
//     contact           contact walls, first stage: the ghosts beyond the wall on which the body
//                       presses; other stages: those of them that the wall would pull, (RP.52)
//     contact search: samples   contact between bodies, first stage: surface particles and
//                       ghosts of each block, with their positions
//     contact search: cells     those of a body in a cell list, if its box meets that of another
//     contact search: points    ghosts whose foot point lies on another body, and the fit of
//                       that body there, (RP.58)
//     tractions         contact between bodies: tractions at the contact points, (RP.56)
//     ghosts            velocity and stress of each ghost from the surface records: (RP.48) with
//                       the present normal and (RP.45) at free surfaces, (RP.46) and (RP.47) at
//                       walls, or (RP.49) as in the paper; beyond the edge of a contact wall, the
//                       values at the edge, (RP.81). Ghosts of free surfaces move with their fits
//                       (RP.60)
//     images            periodic bodies: velocity and stress of the slots beyond a period
//     advance           grad u and div sigma of every particle by the moment matrix (RP.20), or
//                       as in the paper (RP.19); its rates (RP.13), the next state and its stress
//                       (RP.3)-(RP.9)
//
// After the last stage:
//
//     momentum          contact with bodies or walls: the momentum of each body, its budget
//                       (RP.68), (RP.98), and the small velocity that makes the two equal
//                       (RP.69)
//
// A step only moves particles. remesh.cpp returns them to the lattice; solver.cpp decides when that
// is due. The rows below list for each phase what it reads (of its own block, `own`; also of
// neighbouring blocks, `near`; of all blocks, `all`), what it writes, and its function.
namespace pliant::remeshed {

using scheduler::Phase;
using scheduler::Reach;
using namespace resource;
using enum Group;

namespace {

/// Particles and ghosts: the slots that images copy.
Resources repeated(Group group, int copy) { return particles(group, copy) + ghosts(group, copy); }

}  // namespace

template <class T, int D>
Step<T, D>::Step(State<T, D>& state, const Case& settings,
                 const kernels::RemeshedTable<T, D>& kernels)
    : state_(state),
      settings_(settings),
      work_(state, settings, kernels),
      contact_(state, settings, kernels),
      momentum_(state, settings),
      motion_(state, settings, work_.weighs_held_bodies()) {}

template <class T, int D>
std::vector<Phase> Step<T, D>::phases() {
  work_.prepare_blocks();
  std::vector<Phase> phases;
  for (int stage = 0; stage < 4; ++stage) {
    add_shear(phases, stage);
    add_ghosts(phases, stage, false);
    add_advance(phases, stage);
  }
  if (momentum_.is_needed()) {
    momentum_.add_phases(phases, [this]() -> typename ContactMomentumCorrection<T, D>::Impulses {
      return {contact_.fold(), work_.body_force_impulse(), work_.wall_impulse(), work_.sticks()};
    });
  }
  return phases;
}

template <class T, int D>
std::vector<Phase> Step<T, D>::ghost_phases() {
  std::vector<Phase> phases;
  add_shear(phases, 0);
  add_ghosts(phases, 0, true);
  if (state_.boundaries.have_tractions()) {
    PhaseRows(phases).each("whole stress", own(whole(shear_shares)) + near(whole(loaded_facets)),
                           own(particles(stress)),
                           [this](int block) { work_.give_back_shear_stresses(block); });
  }
  return phases;
}

template <class T, int D>
std::vector<Phase> Step<T, D>::stress_phases() {
  work_.prepare_blocks();
  std::vector<Phase> phases;
  PhaseRows(phases).each("stress", read_by_evaluate_stress(), written_by_evaluate_stress(),
                         [this](int block) { work_.evaluate_stress(block); });
  if (motion_.is_needed()) motion_.add_phases(phases);
  if (momentum_.is_needed()) momentum_.add_phases(phases, {});
  return phases;
}

template <class T, int D>
void Step<T, D>::add_ghosts(std::vector<Phase>& phases, int stage, bool all_of_them) {
  using Work = StageWork<T, D>;
  const int current = buffer_of(stage), parity = stage % 2;
  PhaseRows rows = PhaseRows(phases).at_stage(stage);
  if (is_periodic()) {
    rows.each("image positions",
              near(repeated(drift, drift_buffer_of(stage))) + own(whole(image_sources)),
              own(images(drift, drift_buffer_of(stage))), at(stage, &Work::copy_image_positions));
  }
  rows.each("surface", read_by_surface(stage), own(whole(records)),
            at(stage, &Work::write_records));
  if (state_.boundaries.have_contact()) {
    rows.each("contact", near(whole(records) + whole(fits)) + own(ghosts(drift) + whole(contact)),
              own(whole(contact) + whole(kinds)),
              at(stage, stage == 0 ? &Work::decide_wall_contact : &Work::release_wall_contact));
  }
  if (contact_.is_needed()) {
    if (stage == 0) contact_.add_search(phases);
    contact_.add_tractions(phases, stage);
  }
  rows.each("ghosts", read_by_ghosts(stage, all_of_them), written_by_ghosts(stage),
            at(stage, all_of_them ? &Work::fill_all_ghosts : &Work::fill_reached_ghosts));
  if (is_periodic()) {
    Resources read = repeated(velocity, current) + repeated(stress, parity);
    Resources written = images(velocity, current) + images(stress, parity);
    if (reads_volumes(settings_)) {
      read = read + repeated(material, current);
      written = written + images(material, current);
    }
    rows.each("images", near(read) + own(whole(image_sources)), own(written),
              at(stage, &Work::copy_image_states));
  }
}

template <class T, int D>
void Step<T, D>::add_shear(std::vector<Phase>& phases, int stage) {
  using Work = StageWork<T, D>;
  if (!state_.boundaries.have_tractions()) return;
  const int buffer = drift_buffer_of(stage);
  PhaseRows rows = PhaseRows(phases).at_stage(stage);
  rows.each("shear",
            near(particles(drift, buffer) + ghosts(drift, buffer)) + own(whole(loaded_facets)),
            own(whole(shear_forces)), at(stage, &Work::evaluate_shear_forces));
  const Accesses stresses = own(particles(stress, stage % 2) + whole(shear_shares));
  rows.each("shear stress", stresses + near(whole(loaded_facets) + whole(shear_forces)), stresses,
            at(stage, &Work::take_shear_stresses));
}

template <class T, int D>
Accesses Step<T, D>::read_by_surface(int stage) const {
  const int current = buffer_of(stage), parity = stage % 2;
  const Accesses reads = own(particles(velocity, current) + particles(stress, parity) +
                             particles(material, current) + particles(constants) + whole(fits));
  const bool renews_slopes = slopes_at(stage, 0, damps_adaptively(settings_)).are_renewed;
  if (!renews_slopes) return reads + own(whole(records));
  return reads +
         near(particles(drift, drift_buffer_of(stage)) + particles(velocity, current) +
              slots(constants) + whole(interior)) +
         own(whole(records));
}

// The work of loads and walls needs phi. Walls with slip need the positions of particles and
// ghosts, to see how much the material that they push has spread. Rigid ghosts (RP.59) read the
// particles themselves. Ghosts that no particle reads have no fits; they drift with the velocities
// of earlier stages.
template <class T, int D>
Accesses Step<T, D>::read_by_ghosts(int stage, bool all_of_them) const {
  const int current = buffer_of(stage);
  Accesses reads = near(whole(records) + whole(fits)) + own(whole(contact) + whole(contact_points) +
                                                            whole(tractions) + slots(constants));
  if (settings_.ghosts == GhostTreatment::rigid) {
    reads = reads + near(particles(drift, drift_buffer_of(stage)) + particles(velocity, current)) +
            own(ghosts(drift, drift_buffer_of(stage)));
  }
  if (state_.boundaries.have_contact()) reads = reads + near(whole(kinds));
  if (state_.boundaries.have_attached_slip_walls() || state_.boundaries.have_contact()) {
    reads = reads +
            near(particles(drift, drift_buffer_of(stage)) + ghosts(drift, drift_buffer_of(stage)));
  }
  if (all_of_them || stage < 2) return reads;
  return reads +
         (stage == 2 ? own(ghosts(velocity, 0) + ghosts(velocity, 1)) : own(ghosts(velocity, 2)));
}

template <class T, int D>
Accesses Step<T, D>::written_by_ghosts(int stage) const {
  Accesses writes =
      own(ghosts(velocity, buffer_of(stage)) + ghosts(stress, stage % 2) + whole(corrections));
  if (!state_.boundaries.have_contact()) return writes;
  return writes + own(whole(contact) + whole(wall_impulse));
}

// Neighbours from a search may belong to any block, since particles that are far apart on the
// lattice may have come near. All else in a step uses the lattice: the differences of (RP.23) and
// grad phi of surface particles (RP.61) follow material lines, and ghosts keep their fits.
template <class T, int D>
void Step<T, D>::add_advance(std::vector<Phase>& phases, int stage) {
  for (const bool are_listed : {false, true}) {
    const std::vector<int> blocks = blocks_where(are_listed);
    if (blocks.empty()) continue;
    const Reach reach = are_listed ? Reach::all : Reach::neighbours;
    const Accesses writes = written_by_update(stage) + own(whole(corrections));
    PhaseRows(phases, blocks)
        .at_stage(stage)
        .each("advance", read_by_advance(stage, reach), writes,
              at(stage, &StageWork<T, D>::advance));
  }
}

template <class T, int D>
Accesses Step<T, D>::read_by_advance(int stage, Reach reach) const {
  const int current = buffer_of(stage), parity = stage % 2;
  Resources listed = repeated(drift, drift_buffer_of(stage)) + repeated(velocity, current) +
                     repeated(stress, parity);
  Resources adjacent = images(drift, drift_buffer_of(stage)) + images(velocity, current) +
                       images(stress, parity) + whole(interior);
  if (reads_volumes(settings_)) {
    listed = listed + repeated(material, current);
    adjacent = adjacent + images(material, current);
  }
  return Accesses(listed, reach) + read_by_update(stage) +
         own(whole(corrections) + whole(contact) + whole(fits) + whole(shear_shares)) +
         near(adjacent + whole(loaded_facets) + whole(shear_forces));
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

template <class T, int D>
bool Step<T, D>::is_periodic() const {
  return std::any_of(state_.bodies.begin(), state_.bodies.end(),
                     [](const Body<T, D>& body) { return body.lattice.is_periodic(); });
}

template <class T, int D>
void Step<T, D>::prepare(double time_step) {
  contact_.prepare(time_step);
  work_.prepare(time_step);
}

template class Step<double, 2>;
template class Step<double, 3>;
template class Step<float, 2>;
template class Step<float, 3>;

}  // namespace pliant::remeshed

#pragma once

#include "engine/remeshed/state.hpp"
#include "engine/remeshed/surroundings.hpp"

// A body contact_points a contact wall, presses against it and leaves it; nothing bonds them.
//
//          |  body  |
//     f f f \______/ f f f
//     -------------------wall
//     f f f c c c c f f f f
//     f f f c c c c f f f f
//
// Above the wall ghosts stay those of a free surface. Beyond it a slot has two ghosts, each with
// its fits: f of the free surface and c of the wall. Once per step one of the two is chosen for
// each slot, by where the surface stands and whether the wall would push, so that a patch of
// contact grows and shrinks by whole slots. A slot where the wall would pull in a later stage is
// let go there and then.
//
// No penalty stiffness, so no number to choose and no shorter time step: the wall acts through the
// ghosts of (RP.46) and (RP.47) alone.
namespace pliant::remeshed {

/// How high above a wall the surface may stand where contact begins [h], (RP.52): contact farther
/// away begins too early.
inline constexpr double contact_onset_height = 0.01;

/// (RP.52): which ghost of each slot of a block beyond a contact wall is active, at the start of a
/// step, from the records of the surface particles and from which one was active before. The kinds
/// of the slots tell it to the next remeshing. Deciding twice decides the same.
template <class T, int D>
void decide_contact(Body<T, D>& body, int block, const Surroundings<D>& around,
                    const kernels::RemeshedTable<T, D>& kernels);

/// (RP.52): lets go of the slots of a block where the wall would pull in the present stage.
template <class T, int D>
void release_contact(Body<T, D>& body, int block, const Surroundings<D>& around,
                     const kernels::RemeshedTable<T, D>& kernels);

/// (RP.65): adds the push of each contact wall on the ghosts of a block during `duration` [s] to
/// impulse[wall], and its work and what friction takes, (RP.99), to `energy`, from the records of
/// the surface particles and the places of the slots at a stage. Whether the body sticks to a wall
/// somewhere, (RP.73).
template <class T, int D>
bool add_impulse(const Body<T, D>& body, int block, int stage, const Surroundings<D>& around,
                 double duration, const kernels::RemeshedTable<T, D>& kernels, Point<D>* impulse,
                 EnergyBudget& energy);

/// (RP.55): [slot] of the contact ghosts nearest to the wall, the pressure of the wall on the body
/// at their feet [Pa], from the records that filling the ghosts has left; 0 of all other slots.
template <class T, int D>
std::vector<double> wall_pressure(const Body<T, D>& body, const Surroundings<D>& around,
                                  const kernels::RemeshedTable<T, D>& kernels);

}  // namespace pliant::remeshed

#pragma once

#include <span>

#include "engine/remeshed/loads/surroundings.hpp"
#include "engine/remeshed/loads/wall_push.hpp"
#include "engine/remeshed/state/state.hpp"

// A body touches a contact wall, presses against it and leaves it; nothing bonds them.
//
//          |  body  |
//     f f f \______/ f f f
//     -------------------wall
//     f f f c c c c f f f f
//     f f f c c c c f f f f
//
// Above the wall, ghosts are those of a free surface. Beyond it a slot has two ghosts, each with
// its own fits: f of the free surface and c of the wall. Once per step, one of them is chosen for
// each slot, by the height of the surface and by whether the wall would push. So a patch of contact
// grows and shrinks by whole slots. A slot where the wall would pull in a later stage is released
// in that stage.
//
// There is no penalty stiffness, so there is no parameter to choose and no shorter time step: the
// wall acts only through the ghosts of (RP.46) and (RP.47).
namespace pliant::remeshed {

/// Largest height of the surface above a wall at which contact begins [h], (RP.52). With a larger
/// height it would begin too early.
inline constexpr double contact_onset_height = 0.01;

/// (RP.52): decides which ghost of each slot of a block beyond a contact wall is active, at the
/// start of a step, from the records of the surface particles and from the former decision. The
/// kinds of the slots pass the decision to the next remeshing. Deciding twice gives the same
/// result.
template <class T, int D>
void decide_contact(Body<T, D>& body, int block, const Surroundings<D>& around,
                    const kernels::RemeshedTable<T, D>& kernels);

/// (RP.52): releases the slots of a block where the wall would pull in the present stage.
template <class T, int D>
void release_contact(Body<T, D>& body, int block, const Surroundings<D>& around,
                     const kernels::RemeshedTable<T, D>& kernels);

/// (RP.65): adds the push of each contact wall on the ghosts of a block during `duration` [s] to
/// impulse[wall] and, where there are any, to pushes[wall], and its work and the loss by friction,
/// (RP.99), to `energy`. Reads the records of
/// the surface particles and the places of the slots at a stage. Returns whether the body sticks to
/// a wall somewhere, (RP.73).
template <class T, int D>
bool add_impulse(const Body<T, D>& body, int block, int stage, const Surroundings<D>& around,
                 double duration, const kernels::RemeshedTable<T, D>& kernels,
                 std::span<WallPush<D>> pushes, Point<D>* impulse, EnergyBudget& energy);

/// (RP.55): [slot] pressure of the wall on the body at the feet of the contact ghosts nearest to
/// the wall [Pa], from the records that were used to fill the ghosts; 0 for all other slots.
template <class T, int D>
std::vector<double> wall_pressure(const Body<T, D>& body, const Surroundings<D>& around,
                                  const kernels::RemeshedTable<T, D>& kernels);

}  // namespace pliant::remeshed

#include "engine/remeshed/remeshing/remeshing_due.hpp"

#include <algorithm>

#include "engine/case/placement.hpp"
#include "engine/remeshed/contact/relative_motion.hpp"
#include "engine/remeshed/ghosts/lasting_correction.hpp"

namespace pliant::remeshed {

namespace {

// Ghosts between bodies, or between a body and a contact wall, are for the places of the bodies at
// the last remeshing. But bodies that fly towards each other do not deform, and the edge of a
// contact moves.
constexpr std::int64_t most_steps_in_contact = 10;

// Waves across a thin body grow where its surface crosses a row of nodes, unless this place moves
// along the surface. More remeshings would cost energy.
constexpr std::int64_t most_steps_of_swinging = 300;

// Bodies without walls and loads fly apart again after a collision.
template <class T, int D>
bool may_rest(const State<T, D>& state) {
  return !state.boundaries.walls.empty() ||
         std::ranges::any_of(state.bodies, [](const Body<T, D>& body) { return body.bears_loads; });
}

// (RP.96). If nothing moves, each remeshing would only add its own error.
template <class T, int D>
bool moves_in_contact(const Case& settings, const State<T, D>& state) {
  const auto& bodies = state.bodies;
  if (!settings.contacts.empty() && !may_rest(state)) return true;
  const auto moves = [&](const ContactCase& contact) {
    const bool keeps_places = contact.law == ContactLaw::tied && has_supported_ties(settings);
    return !keeps_places && have_moved_apart(bodies[contact.bodies[0]], bodies[contact.bodies[1]]);
  };
  return std::ranges::any_of(settings.contacts, moves) ||
         std::ranges::any_of(bodies, [&](const Body<T, D>& body) {
           return has_moved_at_walls<T, D>(body, state.boundaries, state.remeshed_poses);
         });
}

// (RP.108). Other bodies do not gain from it: those whose shear stress does not relax gain more
// energy with frequent remeshings.
template <class T, int D>
bool swings(const State<T, D>& state) {
  return std::ranges::any_of(state.bodies, [](const Body<T, D>& body) {
    return relaxes_shear(body) && surface_has_crossed_rows(body);
  });
}

}  // namespace

template <class T, int D>
bool remeshing_is_due(const Case& settings, const State<T, D>& state) {
  using Policy = decltype(Case::remeshing)::Policy;
  const Clock& clock = state.clock;
  switch (settings.remeshing.policy) {
    case Policy::every:
      return clock.steps_since_remeshing >= settings.remeshing.every;
    case Policy::adaptive:
      return clock.accumulated_strain > settings.remeshing.strain_threshold ||
             clock.deformation > settings.remeshing.deformation_threshold ||
             (clock.steps_since_remeshing >= most_steps_in_contact &&
              moves_in_contact<T, D>(settings, state)) ||
             (clock.steps_since_remeshing >= most_steps_of_swinging && swings(state));
    case Policy::never:
      return false;
  }
  return false;
}

template bool remeshing_is_due<double, 2>(const Case&, const State<double, 2>&);
template bool remeshing_is_due<double, 3>(const Case&, const State<double, 3>&);
template bool remeshing_is_due<float, 2>(const Case&, const State<float, 2>&);
template bool remeshing_is_due<float, 3>(const Case&, const State<float, 3>&);

}  // namespace pliant::remeshed

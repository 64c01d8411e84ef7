#include "engine/remeshed/remeshing/remeshing_due.hpp"

#include <algorithm>

#include "engine/remeshed/contact/wall_contact.hpp"

namespace pliant::remeshed {

namespace {

// Ghosts between bodies, or between a body and a contact wall, are for the places of the bodies at
// the last remeshing. But bodies that fly towards each other do not deform, and the edge of a
// contact moves.
constexpr std::int64_t most_steps_in_contact = 10;

// (RP.96). If nothing moves, each remeshing would only add its own error.
template <class T, int D>
bool moves_in_contact(const Case& settings, const State<T, D>& state) {
  return !settings.contacts.empty() ||
         std::ranges::any_of(state.bodies, [&state](const Body<T, D>& body) {
           return has_moved_at_walls(body, state.boundaries, state.clock.time);
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
              moves_in_contact(settings, state));
    case Policy::never:
      return false;
  }
  return false;
}

template bool remeshing_is_due(const Case&, const State<double, 2>&);
template bool remeshing_is_due(const Case&, const State<double, 3>&);
template bool remeshing_is_due(const Case&, const State<float, 2>&);
template bool remeshing_is_due(const Case&, const State<float, 3>&);

}  // namespace pliant::remeshed

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "engine/case/checks/check.hpp"
#include "engine/geometry/overlap.hpp"

namespace pliant {
namespace {

/// Largest depth of a point inside both shapes at t = 0 [spacings], half of their overlap. Contact
/// pushes them apart at once and so creates energy. Tied bodies keep their places.
constexpr double deepest_contact = 0.05, deepest_tie = 0.25;

void check_places(const Check& check, std::size_t index) {
  const Case& a_case = check.a_case;
  const ContactCase& contact = a_case.contacts[index];
  const BodyCase& first = a_case.bodies[contact.bodies[0]];
  const BodyCase& second = a_case.bodies[contact.bodies[1]];
  const double spacing = a_case.discretisation.spacing;
  if (!(spacing > 0) || !is_whole(first.geometry, a_case.dimension) ||
      !is_whole(second.geometry, a_case.dimension)) {
    return;
  }
  const double depth = overlap(first.geometry, second.geometry, spacing, a_case.dimension);
  const Place place = check.place("contact", index, "bodies");
  const bool is_tied = contact.law == ContactLaw::tied;
  if (depth > (is_tied ? deepest_tie : deepest_contact) * spacing) {
    check.problems.add(place,
                       fmt::format("bodies \"{}\" and \"{}\" overlap by {:.3g} at the start",
                                   first.name, second.name, 2 * depth),
                       "move one of them, or remove the contact");
  } else if (is_tied && depth < -0.75 * spacing) {
    check.problems.add(
        place,
        fmt::format("bodies \"{}\" and \"{}\" are tied but do not meet", first.name, second.name),
        "let their surfaces touch at the start");
  }
}

// The first remeshing would remove what a body has behind a contact wall, (RP.54).
void check_contact_wall(const Check& check, std::size_t body_index, std::size_t wall_index) {
  const Case& a_case = check.a_case;
  const BodyCase& body = a_case.bodies[body_index];
  const BoundaryCase& wall = a_case.boundaries[wall_index];
  const double spacing = a_case.discretisation.spacing;
  if (wall.kind != BoundaryCase::Kind::contact_wall || !(spacing > 0) ||
      !is_whole(body.geometry, a_case.dimension) || !is_whole(wall.geometry, a_case.dimension)) {
    return;
  }
  // Walls are mostly simple shapes; the body is only evaluated at points inside the wall.
  const double depth = overlap(wall.geometry, body.geometry, spacing, a_case.dimension);
  if (depth <= deepest_contact * spacing) return;
  check.problems.add(
      check.place("body", body_index, "geometry"),
      fmt::format("body \"{}\" overlaps the contact wall \"{}\" by {:.3g} at the start", body.name,
                  wall.name, 2 * depth),
      "move the body or the wall until they stand apart, or subtract the wall from "
      "the body");
}

}  // namespace

// At the edge of contact, loaded ghosts beside free ones distort the level set until the next
// remeshing.
void check_contacts(const Check& check) {
  for (std::size_t b = 0; b < check.a_case.bodies.size(); ++b) {
    for (std::size_t w = 0; w < check.a_case.boundaries.size(); ++w) {
      check_contact_wall(check, b, w);
    }
  }
  const auto& contacts = check.a_case.contacts;
  std::set<std::array<int, 2>> taken;
  bool any_separates = false;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    std::array<int, 2> pair = contacts[i].bodies;
    if (pair[0] < 0 || pair[1] < 0) continue;
    any_separates = any_separates || row_of(contacts[i].law).separates;
    std::sort(pair.begin(), pair.end());
    if (!taken.insert(pair).second) {
      check.problems.add(
          check.place("contact", i, "bodies"),
          fmt::format("bodies \"{}\" and \"{}\" are in two [[contact]] tables",
                      check.a_case.bodies[pair[0]].name, check.a_case.bodies[pair[1]].name),
          "keep one of them");
    }
    if (pair[0] != pair[1]) {
      check_places(check, i);
    } else if (check.a_case.rules == nullptr || !check.a_case.rules->has_self_contact) {
      check.problems.add(check.place("contact", i, "bodies"), "bodies names the same body twice",
                         "name two different bodies, or choose another method");
    }
  }
  if (any_separates && check.a_case.remeshing.policy == decltype(Case::remeshing)::Policy::never) {
    check.problems.add(check.place("remeshing", "every"), "bodies in contact need remeshings",
                       "write every = \"adaptive\"");
  }
  if (!contacts.empty() && check.a_case.ghosts != GhostTreatment::linear) {
    check.problems.add(check.place("ghosts", "treatment"),
                       "contact between bodies needs linear ghosts",
                       "write treatment = \"linear\", or remove the key");
  }
}

}  // namespace pliant

#include "engine/remeshed/ties.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pliant::remeshed {

namespace {

// Measured for blocks that an inclined interface cuts, docs/decisions/0072.
void warn_of_inclined_ties(const Case& a_case, std::vector<std::string>& warnings) {
  const auto is_box = [&](int body) {
    return a_case.bodies[body].geometry.kind == Shape::Kind::box;
  };
  for (const ContactCase& contact : a_case.contacts) {
    if (contact.law != ContactLaw::tied || std::ranges::all_of(contact.bodies, is_box)) continue;
    warnings.push_back(fmt::format(
        "bodies `{}` and `{}` are tied, and are not both boxes: where their joint lies at an angle "
        "to the lattice, they bend by up to 30 % too much or too little; take method = "
        "\"total_lagrangian\" for bodies that keep their neighbours",
        a_case.bodies[contact.bodies[0]].name, a_case.bodies[contact.bodies[1]].name));
  }
}

// Measured for cubes of two tied halves under tension, docs/decisions/0072. A periodic joint has no
// edges along its axis.
void warn_of_edges_of_ties(const Case& a_case, std::vector<std::string>& warnings) {
  const auto is_tied = [](const ContactCase& contact) { return contact.law == ContactLaw::tied; };
  if (std::ranges::none_of(a_case.contacts, is_tied)) return;
  const auto endless = std::ranges::count(a_case.periodic.axis, true);
  if (endless >= a_case.dimension - 1) return;
  warnings.emplace_back(
      a_case.dimension == 2
          ? "where a joint of tied bodies ends at their surface, stresses are up to 25 % too "
            "small; take method = \"total_lagrangian\" for bodies that keep their neighbours"
          : "along the edges of a joint of tied bodies stresses are up to 35 % too small, at its "
            "corners up to 75 %, where it opens; take method = \"total_lagrangian\" for bodies "
            "that keep their neighbours");
}

}  // namespace

void warn_of_ties(const Case& a_case, std::vector<std::string>& warnings) {
  warn_of_inclined_ties(a_case, warnings);
  warn_of_edges_of_ties(a_case, warnings);
}

}  // namespace pliant::remeshed

#include "engine/undeformed/round_bodies.hpp"

#include "engine/case/placement.hpp"
#include "engine/geometry/is_round.hpp"

namespace pliant::undeformed {

void warn_of_round_bodies(const Case& a_case, std::span<const ThinBodyError> errors,
                          std::vector<std::string>& warnings) {
  if (!has_boundary(a_case, BoundaryCase::Kind::contact_wall) && a_case.contacts.empty()) return;
  warn_of_thin_bodies(a_case, errors, warnings,
                      [](const BodyCase& body) { return has_round_part(body.geometry); });
}

}  // namespace pliant::undeformed

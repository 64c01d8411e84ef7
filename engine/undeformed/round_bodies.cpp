#include "engine/undeformed/round_bodies.hpp"

#include <algorithm>

#include "engine/case/placement.hpp"
#include "engine/geometry/is_round.hpp"

namespace pliant::undeformed {

namespace {

bool has_round_part(const Shape& shape) {
  return is_round(shape) || std::ranges::any_of(shape.operands, has_round_part);
}

}  // namespace

void warn_of_round_bodies(const Case& a_case, std::span<const ThinBodyError> errors,
                          std::vector<std::string>& warnings) {
  if (!has_boundary(a_case, BoundaryCase::Kind::contact_wall) && a_case.contacts.empty()) return;
  Case round = a_case;
  std::erase_if(round.bodies, [](const BodyCase& body) { return !has_round_part(body.geometry); });
  warn_of_thin_bodies(round, errors, warnings);
}

}  // namespace pliant::undeformed

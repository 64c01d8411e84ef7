#include "engine/case/checks/resolution.hpp"

#include <fmt/format.h>

#include <cmath>

#include "engine/case/method_rules.hpp"
#include "engine/geometry/closed_mesh.hpp"

namespace pliant {

std::string Resolution::remedy(double enough) const {
  return of_elements ? fmt::format("use a finer mesh (elements of {:.3g} m or below)", enough)
                     : fmt::format("use a finer spacing (discretisation.spacing = {:.3g} or below)",
                                   enough);
}

Resolution resolution_of(const Case& a_case, const BodyCase& body) {
  if (!has_elements(a_case, body)) return {a_case.discretisation.spacing, false};
  const ClosedMesh& mesh = *body.geometry.mesh;
  return {std::cbrt(6 * mesh.volume() / static_cast<double>(mesh.elements())), true};
}

}  // namespace pliant

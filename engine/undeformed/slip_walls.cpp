#include "engine/undeformed/slip_walls.hpp"

#include <fmt/format.h>

#include "engine/case/placement.hpp"
#include "engine/geometry/overlap.hpp"

namespace pliant::undeformed {

namespace {

/// How deep a body lies in a slip wall at t = 0 [m], or 0 if that is less than half a spacing.
double depth_in_slip_wall(const Case& a_case, const BodyCase& body, const BoundaryCase& boundary) {
  if (boundary.kind != BoundaryCase::Kind::slip_wall) return 0;
  const double spacing = a_case.discretisation.spacing;
  const double depth = overlap(boundary.geometry, body.geometry, spacing, a_case.dimension);
  return depth > spacing / 2 ? depth : 0;
}

}  // namespace

Case ended_at_slip_walls(const Case& a_case, bool (*has_elements)(const Shape&)) {
  Case ended = a_case;
  load_meshes(ended);
  for (BodyCase& body : ended.bodies) {
    if (has_elements(body.geometry)) continue;
    Shape shape;
    shape.kind = Shape::Kind::subtract;
    shape.operands = {body.geometry};
    for (const BoundaryCase& boundary : ended.boundaries) {
      if (depth_in_slip_wall(ended, body, boundary) > 0) {
        shape.operands.push_back(boundary.geometry);
      }
    }
    if (shape.operands.size() > 1) body.geometry = shape;
  }
  return ended;
}

void warn_of_elements_in_slip_walls(const Case& a_case, bool (*has_elements)(const Shape&),
                                    std::vector<std::string>& warnings) {
  for (const BodyCase& body : a_case.bodies) {
    if (!has_elements(body.geometry)) continue;
    for (const BoundaryCase& boundary : a_case.boundaries) {
      const double depth = depth_in_slip_wall(a_case, body, boundary);
      if (depth == 0) continue;
      warnings.push_back(fmt::format(
          "body `{}` reaches {:.3g} m into the slip wall `{}`, where its elements still resist; "
          "use a mesh that ends at the wall",
          body.name, depth, boundary.name));
    }
  }
}

}  // namespace pliant::undeformed

#include "engine/undeformed/slip_walls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/case/checks/thickness.hpp"
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

bool lies_along_lattice(const Shape& wall) {
  if (wall.kind == Shape::Kind::box) return true;
  if (wall.kind != Shape::Kind::half_space) return false;
  constexpr double rounding = 1e-9;
  const double largest =
      std::max({std::abs(wall.normal[0]), std::abs(wall.normal[1]), std::abs(wall.normal[2])});
  return std::ranges::count_if(wall.normal, [&](double component) {
           return std::abs(component) > rounding * largest;
         }) == 1;
}

/// Whether a ball is inside the body, which then has to follow its surface all around.
bool is_core(const Shape& wall, const Box<3>& body, int dimension) {
  if (wall.kind != Shape::Kind::ball) return false;
  for (int a = 0; a < dimension; ++a) {
    if (wall.centre[a] - wall.radius < body.lower[a]) return false;
    if (wall.centre[a] + wall.radius > body.upper[a]) return false;
  }
  return true;
}

// Balls that bodies meet from one side cause errors of 2 % at most, and holes of collars meet the
// free surface alone.
bool is_off_the_lattice(const Case& a_case, const BoundaryCase& boundary) {
  const Shape& wall = boundary.geometry;
  if (boundary.kind == BoundaryCase::Kind::slip_wall) return !lies_along_lattice(wall);
  const bool holds = boundary.kind == BoundaryCase::Kind::fixed ||
                     boundary.kind == BoundaryCase::Kind::moving_wall;
  const bool is_inclined = wall.kind == Shape::Kind::half_space && !lies_along_lattice(wall);
  return holds && (is_inclined || is_core(wall, box_of_bodies(a_case), a_case.dimension));
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

// Measured for parts of rings and for rings around a rigid core, docs/decisions/0038.
void warn_of_walls_off_the_lattice(const Case& a_case, bool (*has_elements)(const Shape&),
                                   std::vector<std::string>& warnings) {
  static constexpr ThinBodyError errors[] = {
      {13,
       "displacements and forces deviate by 5 to 10 %, and within two spacings of a wall by more, "
       "a wall is curved or lies at an angle to the lattice"}};
  const bool have_elements = std::ranges::any_of(
      a_case.bodies, [&](const BodyCase& body) { return has_elements(body.geometry); });
  const bool are_along_lattice = std::ranges::none_of(
      a_case.boundaries,
      [&](const BoundaryCase& boundary) { return is_off_the_lattice(a_case, boundary); });
  if (have_elements || are_along_lattice) return;
  warn_of_thin_bodies(a_case, errors, warnings);
}

}  // namespace pliant::undeformed

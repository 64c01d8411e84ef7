#include "engine/case/attached_walls.hpp"

#include "engine/case/vocabulary/boundary_kinds.hpp"
#include "engine/geometry/free_surface.hpp"

namespace pliant {

namespace {

Shape half_space(int axis, double position, double normal) {
  Shape shape;
  shape.kind = Shape::Kind::half_space;
  shape.point[axis] = position;
  shape.normal[axis] = normal;
  return shape;
}

}  // namespace

std::vector<Shape> attached_walls(const Case& a_case) {
  std::vector<Shape> walls;
  for (const BoundaryCase& boundary : a_case.boundaries) {
    if (row_of(boundary.kind).is_attached) walls.push_back(boundary.geometry);
  }
  for (int axis = 0; axis < a_case.dimension; ++axis) {
    if (!a_case.periodic.axis[axis]) continue;
    walls.push_back(half_space(axis, a_case.periodic.lower[axis], 1));
    walls.push_back(half_space(axis, a_case.periodic.upper[axis], -1));
  }
  return walls;
}

Shape initial_surface(const Case& a_case, const BodyCase& body) {
  return free_surface(body.geometry, attached_walls(a_case), a_case.dimension,
                      farthest_held * a_case.discretisation.spacing);
}

}  // namespace pliant

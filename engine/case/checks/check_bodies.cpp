#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/case/checks/check.hpp"
#include "engine/geometry/signed_distance.hpp"

namespace pliant {

bool is_whole(const Shape& shape, int dimension) {
  switch (shape.kind) {
    case Shape::Kind::box:
      for (int i = 0; i < dimension; ++i) {
        if (!(shape.lower[i] < shape.upper[i])) return false;
      }
      return true;
    case Shape::Kind::ball:
    case Shape::Kind::capsule:
    case Shape::Kind::cylinder:
      return shape.radius > 0;
    case Shape::Kind::half_space:
      return shape.normal != Vector{};
    case Shape::Kind::mesh:
      return shape.mesh != nullptr;
    default:
      return !shape.operands.empty() &&
             std::all_of(shape.operands.begin(), shape.operands.end(),
                         [dimension](const Shape& part) { return is_whole(part, dimension); });
  }
}

namespace {

void check_extent(const Check& check, std::size_t index, int axis, const Box<3>& box) {
  const Case& a_case = check.a_case;
  const std::string& name = a_case.bodies[index].name;
  const Place place = check.place("body", index, "geometry");
  const double extent = box.upper[axis] - box.lower[axis];
  const double spacing = a_case.discretisation.spacing;
  if (extent <= 0) {
    check.problems.add(place, fmt::format("body \"{}\" is empty", name),
                       "change its geometry so that it contains at least one point");
  } else if (a_case.periodic.axis[axis]) {
    const bool fits = std::isinf(extent) || (box.lower[axis] >= a_case.periodic.lower[axis] &&
                                             box.upper[axis] <= a_case.periodic.upper[axis]);
    if (fits) return;
    check.problems.add(
        place,
        fmt::format("body \"{}\" extends beyond the periodic cell along {}", name, axis_name(axis)),
        "limit it to the cell, or make it infinite along this axis");
  } else if (std::isinf(extent)) {
    check.problems.add(place,
                       fmt::format("body \"{}\" is unbounded along {}", name, axis_name(axis)),
                       "give finite corners, or intersect it with a box");
  } else if (spacing > extent) {
    check.problems.add(
        check.place("discretisation", "spacing"),
        fmt::format("spacing {} is larger than body \"{}\", which is {} wide along {}", spacing,
                    name, extent, axis_name(axis)),
        fmt::format("use spacing = {:.6g} for ten particles across it", extent / 10));
  }
}

void check_start(const Check& check, std::size_t index) {
  const BodyCase& body = check.a_case.bodies[index];
  if (body.stretch != Vector{1, 1, 1} &&
      body.material_as_given.model == MaterialCase::Model::linear) {
    check.problems.add(
        check.place("body", index, "stretch"),
        fmt::format("body \"{}\" has an initial stretch, but its linear material has no undeformed "
                    "reference shape",
                    body.name),
        "use model = \"reduced_polynomial\", \"neo_hookean\" or \"st_venant_kirchhoff\"");
  }
  if (body.stretch != Vector{1, 1, 1} && body.stress) {
    check.problems.add(
        check.place("body", index, "stress"),
        fmt::format("body \"{}\" has an initial stretch, which gives it a stress", body.name),
        "remove stress or stretch");
  }
}

void check_extents(const Check& check, std::size_t index) {
  const Shape& geometry = check.a_case.bodies[index].geometry;
  if (!is_whole(geometry, check.a_case.dimension)) return;
  const Box<3> box = bounding_box(geometry);
  const std::size_t before = check.problems.count();
  for (int axis = 0; axis < check.a_case.dimension && check.problems.count() == before; ++axis) {
    check_extent(check, index, axis, box);
  }
}

}  // namespace

void check_bodies(const Check& check) {
  const toml::node* bodies = check.root.get("body");
  if (!bodies || (bodies->is_array() && bodies->as_array()->empty())) {
    check.problems.add(check.start, "the case has no body",
                       "add [[body]] with name, geometry and material");
  }
  for (std::size_t i = 0; i < check.a_case.bodies.size(); ++i) {
    check_start(check, i);
    check_extents(check, i);
  }
}

}  // namespace pliant

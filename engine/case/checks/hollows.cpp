#include "engine/case/checks/hollows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "engine/case/attached_walls.hpp"
#include "engine/case/checks/probes.hpp"
#include "engine/case/checks/resolution.hpp"
#include "engine/geometry/is_round.hpp"

namespace pliant {

namespace {

/// Adds the round parts of what a shape takes away from another one.
void add_hollows(const Shape& shape, bool is_taken_away, std::vector<const Shape*>& hollows) {
  if (is_taken_away && is_round(shape)) hollows.push_back(&shape);
  for (std::size_t i = 0; i < shape.operands.size(); ++i) {
    const bool removes = shape.kind == Shape::Kind::subtract && i > 0;
    add_hollows(shape.operands[i], is_taken_away != removes, hollows);
  }
}

/// The radius of the smallest free hollow of a body [m]; infinite without one.
double smallest_hollow(const Case& a_case, const BodyCase& body) {
  constexpr double rounding = 1e-6;
  constexpr double endless = std::numeric_limits<double>::infinity();
  const int dimension = a_case.dimension;
  std::vector<const Shape*> hollows;
  add_hollows(body.geometry, false, hollows);
  const Box<3> box = bounding_box(body.geometry);
  const double step = step_of_probes(box, dimension);
  if (hollows.empty() || !std::isfinite(step)) return endless;
  const std::vector<Vector> probes = middles(box, dimension, step);
  const std::vector<Shape> walls = attached_walls(a_case);
  // Whether the place of the surface of the hollow nearest to x is one of the body in no wall.
  const auto is_free_near = [&](const Shape& hollow, const Vector& x) {
    const double distance = signed_distance(hollow, x, dimension);
    if (std::abs(distance) > step) return false;
    const Vector out = outward_direction(hollow, x, dimension);
    Vector foot = x;
    for (int a = 0; a < dimension; ++a) foot[a] -= distance * out[a];
    const double apart = a_case.discretisation.spacing / 2;
    return std::abs(signed_distance(body.geometry, foot, dimension)) < rounding * step &&
           std::ranges::all_of(walls, [&](const Shape& wall) {
             return signed_distance(wall, foot, dimension) > apart;
           });
  };
  double smallest = endless;
  for (const Shape* hollow : hollows) {
    const bool is_free =
        std::ranges::any_of(probes, [&](const Vector& x) { return is_free_near(*hollow, x); });
    if (is_free) smallest = std::min(smallest, hollow->radius);
  }
  return smallest;
}

}  // namespace

void warn_of_small_hollows(const Case& a_case, std::span<const ThinBodyError> errors,
                           std::vector<std::string>& warnings) {
  for (const BodyCase& body : a_case.bodies) {
    const Resolution resolution = resolution_of(a_case, body);
    const double radius = smallest_hollow(a_case, body), across = radius / resolution.size;
    const ThinBodyError* error = error_at(errors, across);
    if (error == nullptr) continue;
    warnings.push_back(fmt::format(
        "body `{}` has a hole or a hollow with a radius of {:.2g} {}: {}; {}", body.name, across,
        resolution.units(), error->deviation, resolution.remedy(radius / errors.back().across)));
  }
}

}  // namespace pliant

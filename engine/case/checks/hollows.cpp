#include "engine/case/checks/hollows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "engine/case/attached_walls.hpp"
#include "engine/case/checks/probes.hpp"
#include "engine/geometry/is_round.hpp"

namespace pliant {

namespace {

/// Adds the round parts of what a shape takes away from another one.
void add_hollows(const Shape& shape, bool is_taken_away, std::vector<const Shape*>& hollows) {
  if (is_taken_away && is_round(shape)) hollows.push_back(&shape);
  for (std::size_t i = 0; i < shape.operands.size(); ++i) {
    const bool removes = shape.kind == Shape::Kind::difference && i > 0;
    add_hollows(shape.operands[i], is_taken_away != removes, hollows);
  }
}

/// Whether a part of the surface of a hollow is one of the free surface of the body.
bool is_free(const Shape& hollow, const Shape& surface, const std::vector<Vector>& probes,
             double step, int dimension) {
  constexpr double rounding = 1e-6;
  return std::ranges::any_of(probes, [&](const Vector& x) {
    const double distance = signed_distance(hollow, x, dimension);
    if (std::abs(distance) > step) return false;
    const Vector out = outward_direction(hollow, x, dimension);
    Vector foot = x;
    for (int a = 0; a < dimension; ++a) foot[a] -= distance * out[a];
    return std::abs(signed_distance(surface, foot, dimension)) < rounding * step;
  });
}

/// The radius of the smallest free hollow of a body [m]; infinite without one.
double smallest_hollow(const Case& a_case, const BodyCase& body) {
  double smallest = std::numeric_limits<double>::infinity();
  std::vector<const Shape*> hollows;
  add_hollows(body.geometry, false, hollows);
  if (hollows.empty()) return smallest;
  const Box<3> box = bounding_box(body.geometry);
  const double step = step_of_probes(box, a_case.dimension);
  if (!std::isfinite(step)) return smallest;
  const std::vector<Vector> probes = middles(box, a_case.dimension, step);
  const Shape surface = initial_surface(a_case, body);
  for (const Shape* hollow : hollows) {
    if (hollow->radius < smallest && is_free(*hollow, surface, probes, step, a_case.dimension)) {
      smallest = hollow->radius;
    }
  }
  return smallest;
}

}  // namespace

void warn_of_small_hollows(const Case& a_case, std::span<const ThinBodyError> errors,
                           std::vector<std::string>& warnings) {
  constexpr double rounding = 0.01;
  const double h = a_case.discretisation.spacing;
  for (const BodyCase& body : a_case.bodies) {
    const double radius = smallest_hollow(a_case, body);
    const auto error = std::ranges::find_if(
        errors, [&](const ThinBodyError& one) { return radius < one.across * (1 - rounding) * h; });
    if (error == errors.end()) continue;
    warnings.push_back(
        fmt::format("body `{}` has a hole or a hollow with a radius of {:.2g} spacings: {}; use a "
                    "finer spacing "
                    "(discretisation.spacing = {:.3g} or below)",
                    body.name, radius / h, error->deviation, radius / errors.back().across));
  }
}

}  // namespace pliant

#include "engine/case/checks/narrow_places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "engine/case/attached_walls.hpp"
#include "engine/case/checks/probes.hpp"
#include "engine/case/checks/resolution.hpp"

namespace pliant {

namespace {

constexpr double none = std::numeric_limits<double>::infinity();
constexpr double on_surface = 1e-3;  // of the widest place that is sought

enum class NarrowPlace { gap, part };

/// How far the opposite face is from a place on the surface, if it is nearly parallel and at most
/// `widest` away [m].
double way_across(const Shape& shape, const Vector& foot, int dimension, NarrowPlace place,
                  double widest) {
  constexpr double opposite = -0.95;  // cosine between the normals
  const double sign = place == NarrowPlace::gap ? 1 : -1;
  const Vector out = outward_direction(shape, foot, dimension);
  double way = 10 * on_surface * widest;
  while (way <= widest) {
    Vector x = foot;
    for (int a = 0; a < dimension; ++a) x[a] += sign * way * out[a];
    const double distance = sign * signed_distance(shape, x, dimension);
    if (distance < on_surface * widest) {
      const Vector facing = outward_direction(shape, x, dimension);
      double cosine = 0;
      for (int a = 0; a < dimension; ++a) cosine += out[a] * facing[a];
      return cosine < opposite ? way : none;
    }
    way += distance;
  }
  return none;
}

/// The least way across on one side of the surface of a body, in no wall that holds it, if it is at
/// most `widest` [m].
double narrowest(const Case& a_case, const Shape& shape, NarrowPlace place, double widest) {
  const int dimension = a_case.dimension;
  const Box<3> box = bounding_box(shape);
  const double step = step_of_probes(box, dimension);
  if (!std::isfinite(step)) return none;
  const std::vector<Shape> walls = attached_walls(a_case);
  double least = none;
  for (const Vector& x : middles(box, dimension, step)) {
    const Vector foot = foot_of(shape, x, dimension);
    const bool is_free = std::ranges::all_of(
        walls, [&](const Shape& wall) { return signed_distance(wall, foot, dimension) > 0; });
    if (!is_free || std::abs(signed_distance(shape, foot, dimension)) > on_surface * widest) {
      continue;
    }
    least = std::min(least, way_across(shape, foot, dimension, place, widest));
  }
  return least;
}

void warn_of_places(const Case& a_case, std::span<const ThinBodyError> errors, NarrowPlace place,
                    std::vector<std::string>& warnings) {
  constexpr double of_thickness = 0.8;  // from here on the whole body is as thin
  for (const BodyCase& body : a_case.bodies) {
    const Resolution resolution = resolution_of(a_case, body);
    const bool has_parts =
        !body.geometry.operands.empty() || body.geometry.kind == Shape::Kind::mesh;
    if (resolution.of_elements || !has_parts) continue;
    const double enough = errors.back().across;
    const double width = narrowest(a_case, body.geometry, place, enough * resolution.size);
    const double across = width / resolution.size;
    const ThinBodyError* error = error_at(errors, across);
    if (error == nullptr) continue;
    if (place == NarrowPlace::part && width > of_thickness * thickness(a_case, body)) continue;
    const std::string what = place == NarrowPlace::gap
                                 ? fmt::format("a gap of {:.2g} spacings", across)
                                 : fmt::format("a part {:.2g} spacings thick", across);
    warnings.push_back(fmt::format("body `{}` has {}: {}; {}", body.name, what, error->deviation,
                                   resolution.remedy(width / enough)));
  }
}

}  // namespace

void warn_of_narrow_gaps(const Case& a_case, std::span<const ThinBodyError> errors,
                         std::vector<std::string>& warnings) {
  warn_of_places(a_case, errors, NarrowPlace::gap, warnings);
}

void warn_of_thin_parts(const Case& a_case, std::span<const ThinBodyError> errors,
                        std::vector<std::string>& warnings) {
  warn_of_places(a_case, errors, NarrowPlace::part, warnings);
}

}  // namespace pliant

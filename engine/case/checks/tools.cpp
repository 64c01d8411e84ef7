#include "engine/case/checks/tools.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/case/checks/resolution.hpp"
#include "engine/case/vocabulary/boundary_kinds.hpp"
#include "engine/geometry/is_round.hpp"
#include "engine/geometry/signed_distance.hpp"

namespace pliant {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The least width of `wall` across the axes along which the boxes overlap.
double width_beside(const Box<3>& wall, const Box<3>& body, int dimension) {
  double width = infinity;
  for (int a = 0; a < dimension; ++a) {
    const double rounding = 1e-9 * (body.upper[a] - body.lower[a]);
    const bool is_apart =
        wall.lower[a] > body.upper[a] - rounding || wall.upper[a] < body.lower[a] + rounding;
    const bool covers =
        wall.lower[a] < body.lower[a] + rounding && wall.upper[a] > body.upper[a] - rounding;
    if (!is_apart && !covers) width = std::min(width, wall.upper[a] - wall.lower[a]);
  }
  return width;
}

bool is_contact_wall(const BoundaryCase& wall) {
  return wall.kind == BoundaryCase::Kind::contact_wall;
}

/// The part of a wall that meets a body.
struct Meeting {
  double width = infinity;  ///< [m]
  Resolution resolution;    ///< of the body

  double across() const { return width / resolution.size; }
};

/// Where a wall is the narrowest for the resolution of the body; `resolutions` are [body].
Meeting narrowest(const Case& a_case, const std::vector<Resolution>& resolutions,
                  const BoundaryCase& wall) {
  Meeting narrowest;
  for (std::size_t i = 0; i < a_case.bodies.size(); ++i) {
    const Meeting one = {width_of_tool(a_case, wall, a_case.bodies[i]), resolutions[i]};
    if (i == 0 || one.across() < narrowest.across()) narrowest = one;
  }
  return narrowest;
}

}  // namespace

double width_of_tool(const Case& a_case, const BoundaryCase& wall, const BodyCase& body) {
  if (!row_of(wall.kind).is_wall) return infinity;
  const Shape& shape = wall.geometry;
  if (is_round(shape)) return is_contact_wall(wall) ? 2 * shape.radius : infinity;
  using enum Shape::Kind;
  if (shape.kind != box && shape.kind != mesh && shape.kind != intersect) return infinity;
  return width_beside(bounding_box(shape), bounding_box(body.geometry), a_case.dimension);
}

void warn_of_narrow_tools(const Case& a_case, const NarrowToolErrors& all_errors,
                          std::vector<std::string>& warnings) {
  std::vector<Resolution> resolutions;
  for (const BodyCase& body : a_case.bodies) resolutions.push_back(resolution_of(a_case, body));
  for (const BoundaryCase& wall : a_case.boundaries) {
    const Meeting meeting = narrowest(a_case, resolutions, wall);
    const std::span<const NarrowToolError> errors = !is_contact_wall(wall)    ? all_errors.attached
                                                    : is_round(wall.geometry) ? all_errors.round
                                                                              : all_errors.edged;
    const auto error = std::ranges::find_if(
        errors, [&](const NarrowToolError& e) { return meeting.across() < e.across; });
    if (error == errors.end()) continue;
    warnings.push_back(
        fmt::format("the wall `{}` is {:.2g} {} wide: its force deviates by up to {} %; {}",
                    wall.name, meeting.across(), meeting.resolution.units(), error->deviation,
                    meeting.resolution.remedy(meeting.width / errors.back().across)));
  }
}

void warn_of_tools(const Case& a_case, std::string_view deviation,
                   std::vector<std::string>& warnings) {
  for (const BoundaryCase& wall : a_case.boundaries) {
    const auto meets_a_part = [&](const BodyCase& body) {
      return std::isfinite(width_of_tool(a_case, wall, body));
    };
    if (!is_contact_wall(wall) || std::ranges::none_of(a_case.bodies, meets_a_part)) continue;
    warnings.push_back(
        fmt::format("the contact wall `{}` is round, or presses on a part of a body only: {}",
                    wall.name, deviation));
  }
}

}  // namespace pliant

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

/// What two boxes share along an axis.
struct Overlap {
  double length;  ///< [m], 0 where they are apart
  bool covers;    ///< whether the wall covers the body
};

Overlap overlap_along(int a, const Box<3>& wall, const Box<3>& body) {
  const double rounding = 1e-9 * (body.upper[a] - body.lower[a]);
  const double shared =
      std::min(wall.upper[a], body.upper[a]) - std::max(wall.lower[a], body.lower[a]);
  return {shared > rounding ? shared : 0,
          wall.lower[a] < body.lower[a] + rounding && wall.upper[a] > body.upper[a] - rounding};
}

/// The least width of a contact wall across the axes along which the boxes overlap.
double width_beside(const Box<3>& wall, const Box<3>& body, int dimension) {
  double width = infinity;
  for (int a = 0; a < dimension; ++a) {
    const Overlap overlap = overlap_along(a, wall, body);
    if (overlap.length == 0 || overlap.covers) continue;
    width = std::min(width, wall.upper[a] - wall.lower[a]);
  }
  return width;
}

/// The least length along which a wall holds a body, beside the way that it reaches into it.
double held_width(const Box<3>& wall, const Box<3>& body, int dimension) {
  std::vector<double> lengths;
  for (int a = 0; a < dimension; ++a) {
    const Overlap overlap = overlap_along(a, wall, body);
    if (!overlap.covers) lengths.push_back(overlap.length);
  }
  if (lengths.size() < 2) return infinity;
  std::ranges::sort(lengths);
  return lengths[1] > 0 ? lengths[1] : infinity;
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
  const auto width = is_contact_wall(wall) ? width_beside : held_width;
  return width(bounding_box(shape), bounding_box(body.geometry), a_case.dimension);
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
    warnings.push_back(fmt::format(
        "the wall `{}` is {:.2g} {} wide: {} by up to {} %; {}", wall.name, meeting.across(),
        meeting.resolution.units(),
        is_contact_wall(wall) ? "its force deviates" : "forces and displacements deviate",
        error->deviation, meeting.resolution.remedy(meeting.width / errors.back().across)));
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

#include "engine/undeformed/squeezed_bodies.hpp"

#include <algorithm>

#include "engine/boundaries/walls.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/lattice/point_algebra.hpp"
#include "engine/method/initial_stress.hpp"

namespace pliant::undeformed {

namespace {

constexpr double least_ratio = 0.4;

/// Whether a no-slip wall moves towards the middle of a body at some time.
bool is_squeezed(const Case& a_case, const Boundaries<3>& boundaries, const BodyCase& body) {
  constexpr int times = 32;
  const Box<3> box = bounding_box(body.geometry);
  Point<3> middle;
  for (int a = 0; a < 3; ++a) middle[a] = (box.lower[a] + box.upper[a]) / 2;
  return std::ranges::any_of(boundaries.walls, [&](const Wall<3>& wall) {
    if (!wall.is_attached() || wall.slips()) return false;
    for (int k = 0; k < times; ++k) {
      const Point<3> velocity = wall.velocity((k + 0.5) / times * a_case.time.end);
      if (dot<3>(velocity, wall.normal(middle)) > 0) return true;
    }
    return false;
  });
}

}  // namespace

void warn_of_squeezed_bodies(const Case& a_case, std::span<const ThinBodyError> errors,
                             std::vector<std::string>& warnings) {
  if (a_case.dimension == 2) return;
  const Boundaries<3> boundaries(a_case.boundaries);
  warn_of_thin_bodies(a_case, errors, warnings, [&](const BodyCase& body) {
    return poissons_ratio(body) >= least_ratio && is_squeezed(a_case, boundaries, body);
  });
}

}  // namespace pliant::undeformed

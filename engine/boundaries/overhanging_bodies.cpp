#include "engine/boundaries/overhanging_bodies.hpp"

#include <algorithm>
#include <cmath>

#include "engine/boundaries/overhang.hpp"
#include "engine/geometry/padded.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/lattice/lattice.hpp"
#include "engine/lattice/point_algebra.hpp"

namespace pliant {

namespace {

/// The walls that a body may overhang.
struct Overhang {
  bool slips;      ///< whether the walls do
  double leaning;  ///< least -n.w, n the normal of the free surface at the rim, w that of the wall
};
constexpr Overhang held{false, 0}, sliding{true, 0.55};

template <int D>
bool overhangs(const Case& a_case, const BodyCase& body, const Overhang& sought) {
  constexpr int points = 24;  // along each side of the body
  const Boundaries<D> boundaries(a_case.boundaries);
  const Box<3> box = bounding_box(body.geometry);
  Point<D> pitch;
  for (int a = 0; a < D; ++a) pitch[a] = (box.upper[a] - box.lower[a]) / points;
  const double reach = *std::ranges::max_element(pitch);
  const auto rises_over = [&](const Wall<D>& wall, const Point<D>& x) {
    if (!wall.is_attached() || wall.slips() != sought.slips) return false;
    if (std::abs(wall.distance(x)) > reach) return false;
    const auto rim = way_to_rim<D>(body.geometry, wall, x, reach);
    if (!rim || rim->way.norm() >= reach) return false;
    const Point<D> place = as_point<D>(rim->foot + rim->way);
    const Vector out = outward_direction(body.geometry, padded<D>(place), D);
    return -dot<D>(unpadded<D>(out), wall.normal(place)) > sought.leaning;
  };
  Cell<D> first = {}, last;
  last.fill(points - 1);
  bool found = false;
  for_each_cell<D>(first, last, [&](const Cell<D>& cell) {
    Point<D> x;
    for (int a = 0; a < D; ++a) x[a] = box.lower[a] + (cell[a] + 0.5) * pitch[a];
    found = found || std::ranges::any_of(boundaries.walls,
                                         [&](const Wall<D>& wall) { return rises_over(wall, x); });
  });
  return found;
}

}  // namespace

bool overhangs_a_slip_wall(const Case& a_case, const BodyCase& body) {
  return a_case.dimension == 2 ? overhangs<2>(a_case, body, sliding)
                               : overhangs<3>(a_case, body, sliding);
}

void warn_of_overhangs(const Case& a_case, std::span<const ThinBodyError> errors,
                       std::vector<std::string>& warnings) {
  warn_of_thin_bodies(a_case, errors, warnings, [&](const BodyCase& body) {
    return a_case.dimension == 2 ? overhangs<2>(a_case, body, held)
                                 : overhangs<3>(a_case, body, held);
  });
}

}  // namespace pliant

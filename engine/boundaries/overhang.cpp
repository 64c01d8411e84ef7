#include "engine/boundaries/overhang.hpp"

#include <algorithm>
#include <cmath>

#include "engine/geometry/padded.hpp"
#include "engine/geometry/signed_distance.hpp"

namespace pliant {

namespace {

constexpr double least_slant = 0.2;  // cosine between the surface's normal and into the wall
constexpr double same_plane = 0.25;  // sine of the angle below which the surface faces the wall
constexpr double error = 0.05;       // of the place of the rim, over its distance
constexpr int newton_steps = 3;

template <int D>
bool overhangs(const Case& a_case, const BodyCase& body) {
  constexpr int points = 24;  // along each side of the body
  const Boundaries<D> boundaries(a_case.boundaries);
  const Box<3> box = bounding_box(body.geometry);
  Point<D> pitch;
  for (int a = 0; a < D; ++a) pitch[a] = (box.upper[a] - box.lower[a]) / points;
  const double reach = *std::ranges::max_element(pitch);
  const auto rises_over = [&](const Wall<D>& wall, const Point<D>& x) {
    if (!wall.is_attached() || wall.slips() || std::abs(wall.distance(x)) > reach) return false;
    const auto rim = way_to_rim<D>(body.geometry, wall, x, reach);
    return rim && rim->way.norm() < reach;
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

bool overhangs_a_wall(const Case& a_case, const BodyCase& body) {
  return a_case.dimension == 2 ? overhangs<2>(a_case, body) : overhangs<3>(a_case, body);
}

void warn_of_overhangs(const Case& a_case, std::span<const ThinBodyError> errors,
                       std::vector<std::string>& warnings) {
  Case held = a_case;
  std::erase_if(held.bodies, [&](const BodyCase& body) { return !overhangs_a_wall(a_case, body); });
  warn_of_thin_bodies(held, errors, warnings);
}

template <int D>
std::optional<WayToRim<D>> way_to_rim(const Shape& body, const Wall<D>& wall, const Point<D>& x,
                                      double farthest) {
  const auto phi = [&body](const Column<D>& at) {
    return signed_distance(body, padded<D>(as_point<D>(at)), D);
  };
  const Column<D> into_body = column<D>(wall.normal(x));
  const Column<D> foot = column<D>(x) - wall.distance(x) * into_body;
  const double at_foot = phi(foot);
  if (at_foot < -farthest) return std::nullopt;
  Column<D> rim = foot;
  for (int step = 0; step < newton_steps; ++step) {
    const Vector out = outward_direction(body, padded<D>(as_point<D>(rim)), D);
    const Column<D> normal = Eigen::Map<const Column<D>>(out.data());
    const double slant = normal.dot(into_body);
    const Column<D> along = normal - slant * into_body;
    if (slant > -least_slant || along.norm() < same_plane) return std::nullopt;
    rim -= phi(rim) / along.squaredNorm() * along;
  }
  const Column<D> way = rim - foot;
  const double allowed = error * std::max(way.norm(), farthest);
  const double off_the_wall = wall.distance(as_point<D>(rim));
  if (std::abs(phi(rim)) > allowed || std::abs(off_the_wall) > allowed) return std::nullopt;
  return WayToRim<D>{foot, way, at_foot > 0};
}

template <int D>
bool is_beyond_rim(const Shape& body, const Wall<D>& wall, const Point<D>& x, double by) {
  const auto rim = way_to_rim<D>(body, wall, x, 0);
  return rim && rim->is_beyond && rim->way.norm() > by;
}

template std::optional<WayToRim<2>> way_to_rim<2>(const Shape&, const Wall<2>&, const Point<2>&,
                                                  double);
template std::optional<WayToRim<3>> way_to_rim<3>(const Shape&, const Wall<3>&, const Point<3>&,
                                                  double);
template bool is_beyond_rim<2>(const Shape&, const Wall<2>&, const Point<2>&, double);
template bool is_beyond_rim<3>(const Shape&, const Wall<3>&, const Point<3>&, double);

}  // namespace pliant

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

}  // namespace

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

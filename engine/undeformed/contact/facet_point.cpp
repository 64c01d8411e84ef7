#include "engine/undeformed/contact/facet_point.hpp"

#include <algorithm>

#include "engine/geometry/triangle_foot.hpp"

namespace pliant::undeformed {

std::array<double, 2> nearest_weights(const std::array<Point<2>, 2>& c, const Point<2>& x) {
  const Point<2> along = difference<2>(c[1], c[0]);
  const double square = dot<2>(along, along);
  if (square == 0) return {1, 0};
  const double t = std::clamp(dot<2>(difference<2>(x, c[0]), along) / square, 0., 1.);
  return {1 - t, t};
}

std::array<double, 3> nearest_weights(const std::array<Point<3>, 3>& c, const Point<3>& x) {
  const auto vector = [](const Point<3>& p) { return Eigen::Vector3d(p[0], p[1], p[2]); };
  return foot_on_triangle({vector(c[0]), vector(c[1]), vector(c[2])}, vector(x)).weight;
}

}  // namespace pliant::undeformed

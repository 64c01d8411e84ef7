#include "engine/undeformed/surface_measures.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/geometry/padded.hpp"
#include "engine/method/no_value.hpp"
#include "engine/undeformed/body.hpp"

namespace pliant::undeformed {

namespace {

/// Distance from `origin` along the unit vector `direction` to a piece; negative if the line misses
/// the piece.
template <int D>
double distance_to(const std::array<Point<D>, D>& corner, const Vector& origin,
                   const Vector& direction) {
  constexpr double rim = 1e-4;  // lines between two pieces meet both; slivers are left out
  Eigen::Matrix<double, D, D> columns;
  Eigen::Matrix<double, D, 1> right;
  for (int a = 0; a < D; ++a) {
    columns(a, 0) = direction[a];
    for (int v = 1; v < D; ++v) columns(a, v) = corner[0][a] - corner[v][a];
    right[a] = corner[0][a] - origin[a];
  }
  if (columns.determinant() == 0) return -1;
  const Eigen::Matrix<double, D, 1> found = columns.partialPivLu().solve(right);
  double first_share = 1;
  for (int v = 1; v < D; ++v) {
    if (found[v] < -rim) return -1;
    first_share -= found[v];
  }
  return first_share < -rim ? -1 : found[0];
}

template <int D>
double last_distance(const FreeSurface<D>& surface, const Vector& origin, const Vector& direction) {
  double last = -1;
  for (const auto& corner : surface) {
    last = std::max(last, distance_to<D>(corner, origin, direction));
  }
  return last < 0 ? no_value : last;
}

}  // namespace

template <int D>
double extent(const FreeSurface<D>& surface, const MeasurementCase& m, double t) {
  const double sign = m.lower_side ? -1 : 1;
  double farthest = -std::numeric_limits<double>::infinity();
  for (const auto& corners : surface) {
    for (const Point<D>& corner : corners) {
      const Vector at = padded<D>(corner);
      if (m.where && (*m.where)(at[0], at[1], at[2], t) == 0) continue;
      farthest = std::max(farthest, sign * at[m.axis]);
    }
  }
  return std::isfinite(farthest) ? farthest - sign * m.reference : no_value;
}

template <int D>
double surface_distance(const FreeSurface<D>& surface, const MeasurementCase& m) {
  return last_distance<D>(surface, m.point, m.direction) - m.reference;
}

template <int D>
double mean_radius(const FreeSurface<D>& surface, const MeasurementCase& m) {
  double sum = 0;
  for (int k = 0; k < m.directions; ++k) {
    const double angle = 2 * std::numbers::pi * (k + 0.5) / m.directions;
    sum += last_distance<D>(surface, m.point, {std::cos(angle), std::sin(angle), 0});
  }
  return sum / m.directions;
}

template <int D>
double surface_area(const FreeSurface<D>& surface) {
  double sum = 0;
  for (const auto& corners : surface) {
    double square = 0;
    for (const double a : area_vector<D>(corners)) square += a * a;
    sum += std::sqrt(square);
  }
  return sum;
}

template double extent<2>(const FreeSurface<2>&, const MeasurementCase&, double);
template double extent<3>(const FreeSurface<3>&, const MeasurementCase&, double);
template double surface_distance<2>(const FreeSurface<2>&, const MeasurementCase&);
template double surface_distance<3>(const FreeSurface<3>&, const MeasurementCase&);
template double mean_radius<2>(const FreeSurface<2>&, const MeasurementCase&);
template double mean_radius<3>(const FreeSurface<3>&, const MeasurementCase&);
template double surface_area<2>(const FreeSurface<2>&);
template double surface_area<3>(const FreeSurface<3>&);

}  // namespace pliant::undeformed

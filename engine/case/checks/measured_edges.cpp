#include "engine/case/checks/measured_edges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/case/checks/probes.hpp"

namespace pliant {

namespace {

using Kind = MeasurementCase::Kind;

double product(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

bool lies_along_an_axis(const Vector& normal) {
  constexpr double along = 0.9994;  // cosine of 2 degrees
  return std::ranges::any_of(normal, [](double n) { return std::abs(n) > along; });
}

/// Whether faces with different normals, not all along axes, are within `reach` [m] of `x`.
bool is_at_an_inclined_edge(const Shape& shape, const Vector& x, int dimension, double reach) {
  constexpr double same_face = 0.8;    // cosine
  constexpr double on_surface = 1e-3;  // of the reach
  constexpr int half = 2;              // places to each side of x, along each axis
  std::vector<Vector> normals;
  const int depth = dimension == 2 ? 0 : half;
  for (int i = -half; i <= half; ++i) {
    for (int j = -half; j <= half; ++j) {
      for (int k = -depth; k <= depth; ++k) {
        const Vector from = {x[0] + reach * i / half, x[1] + reach * j / half,
                             x[2] + reach * k / half};
        const Vector foot = foot_of(shape, from, dimension);
        const Vector apart = {foot[0] - x[0], foot[1] - x[1], foot[2] - x[2]};
        if (product(apart, apart) > reach * reach) continue;
        if (std::abs(signed_distance(shape, foot, dimension)) > on_surface * reach) continue;
        const Vector normal = outward_direction(shape, foot, dimension);
        const bool is_known = std::ranges::any_of(
            normals, [&](const Vector& n) { return product(n, normal) > same_face; });
        if (!is_known) normals.push_back(normal);
      }
    }
  }
  return normals.size() > 1 && !std::ranges::all_of(normals, lies_along_an_axis);
}

bool is_at_a_point(const MeasurementCase& measurement) {
  return measurement.kind == Kind::point_displacement || measurement.kind == Kind::point_value ||
         measurement.kind == Kind::material_value;
}

}  // namespace

void warn_of_measured_edges(const Case& a_case, std::string_view deviation,
                            std::vector<std::string>& warnings) {
  for (std::size_t b = 0; b < a_case.bodies.size(); ++b) {
    const BodyCase& body = a_case.bodies[b];
    std::vector<std::string> names;
    for (const MeasurementCase& measurement : a_case.measurements) {
      if (measurement.body != static_cast<int>(b) || !is_at_a_point(measurement)) continue;
      if (is_at_an_inclined_edge(body.geometry, measurement.point, a_case.dimension,
                                 a_case.discretisation.spacing)) {
        names.push_back(measurement.name);
      }
    }
    if (names.empty()) continue;
    const std::string more = names.size() == 1 ? "is"
                             : names.size() == 2
                                 ? fmt::format("and `{}` are", names[1])
                                 : fmt::format("and {} other measurements are", names.size() - 1);
    warnings.push_back(fmt::format(
        "`{}` {} taken within a spacing of an edge of body `{}` at an angle to the axes: {}; turn "
        "the case so that the edges of the body lie along the axes, or measure inside the body",
        names[0], more, body.name, deviation));
  }
}

}  // namespace pliant

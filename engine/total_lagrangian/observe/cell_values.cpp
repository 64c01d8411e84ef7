#include "engine/total_lagrangian/observe/cell_values.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "engine/geometry/padded.hpp"
#include "engine/method/field_components.hpp"
#include "engine/method/field_fit.hpp"
#include "engine/method/no_value.hpp"
#include "engine/method/region_share.hpp"
#include "engine/total_lagrangian/stress_point.hpp"

namespace pliant::total_lagrangian {

namespace {

constexpr double linear_radius = 2.6, quadratic_radius = 3.2;  // [h] radius of a fit

// The value at a stress point of what particles have.
template <class T, int D>
double mean_over_part(const Body<T, D>& body, const Buffer<T>& values, const Cell<D>& cell) {
  const auto corners = body.corners(cell);
  const CellMoments<D> moments = body.moments(corners[0]);
  double sum = 0;
  for (int c = 0; c < (1 << D); ++c) sum += mean_weight<D>(moments, c) * values[corners[c]];
  return sum;
}

// Present place of a stress point.
template <class T, int D>
Point<D> present_place(const Body<T, D>& body, std::int64_t slot, const Cell<D>& cell) {
  Point<D> x = stress_point_place<T, D>(body, slot, cell);
  for (int a = 0; a < D; ++a) x[a] += mean_over_part<T, D>(body, body.displacement[a], cell);
  return x;
}

// The field that a measurement names, at a stress point.
template <class T, int D>
double cell_value(const Body<T, D>& body, std::int64_t slot, const Cell<D>& cell,
                  const std::string& field) {
  const int axis = last_axis(field);
  if (field.starts_with("velocity")) return mean_over_part<T, D>(body, body.velocity[axis], cell);
  if (field.starts_with("displacement")) {
    return mean_over_part<T, D>(body, body.displacement[axis], cell);
  }
  const StressPoint<D> point = stress_point<T, D>(body, slot, cell);
  if (field == "pressure") return point.pressure;
  if (field == "density") return body.material.density / point.volume_ratio;
  if (field.starts_with("strain")) return strain_value<D>(point.deformation_gradient, field);
  return stress_value(full_stress<D>(point.stress, point.pressure), field);
}

/// The share of a cell that a measurement selects.
template <class T, int D>
double selected_share(const Body<T, D>& body, const Cell<D>& cell, const MeasurementCase& m,
                      double t) {
  if (!m.where) return 1;
  const std::array<std::int64_t, (1 << D)> corners = body.corners(cell);
  return share_in_region<D>(*m.where, t, [&](const Point<D>& r) {
    Point<D> x;
    for (int a = 0; a < D; ++a) {
      x[a] = body.lattice.node(cell)[a] + r[a] * body.lattice.spacing;
    }
    for (int c = 0; c < 1 << D; ++c) {
      double weight = 1;
      for (int a = 0; a < D; ++a) weight *= (c >> a) & 1 ? r[a] : 1 - r[a];
      const Point<D> shift = body.shift(corners[c]);
      for (int a = 0; a < D; ++a) x[a] += weight * (shift[a] + body.displacement[a][corners[c]]);
    }
    return x;
  });
}

template <class T, int D, class F>
void for_each_cell(const Body<T, D>& body, F&& f) {
  for (const Block<D>& block : body.layout.blocks()) {
    body.layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
      if (body.fraction[p] > 0) f(p, cell);
    });
  }
}

}  // namespace

template <class T, int D>
double material_value(const Body<T, D>& body, const Vector& start, const std::string& field) {
  FieldFit<D> fit;
  for_each_cell(body, [&](std::int64_t p, const Cell<D>& cell) {
    Point<D> r = stress_point_place<T, D>(body, p, cell);
    double square = 0;
    for (int a = 0; a < D; ++a) {
      r[a] = (r[a] - start[a]) / body.lattice.spacing;
      square += r[a] * r[a];
    }
    if (square >= quadratic_radius * quadratic_radius) return;
    // The stress of a cell that is nearly empty is that of a displacement that hardly counts.
    const double share = body.fraction[p];
    fit.add(r, share * weight_of_value(square, linear_radius),
            share * weight_of_value(square, quadratic_radius),
            cell_value<T, D>(body, p, cell, field));
  });
  return fit.value().value_or(no_value);
}

template <class T, int D>
std::optional<Vector> start_of(const Body<T, D>& body, const Vector& x) {
  using Row = Eigen::Matrix<double, D, 1>;
  double least = std::numeric_limits<double>::infinity();
  std::int64_t nearest = 0;
  Cell<D> nearest_cell = {};
  Row offset = Row::Zero();
  for_each_cell(body, [&](std::int64_t p, const Cell<D>& cell) {
    const Point<D> place = present_place<T, D>(body, p, cell);
    Row r;
    for (int a = 0; a < D; ++a) r[a] = x[a] - place[a];
    if (r.squaredNorm() >= least) return;
    least = r.squaredNorm();
    nearest = p;
    nearest_cell = cell;
    offset = r;
  });
  if (!std::isfinite(least)) return std::nullopt;
  const auto f = stress_point<T, D>(body, nearest, nearest_cell).deformation_gradient;
  Eigen::Matrix<double, D, D> gradient;
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) gradient(i, j) = f[i][j];
  }
  const Row back = gradient.inverse() * offset;
  const double h = body.lattice.spacing;
  if (back.norm() > h * std::sqrt(D)) return std::nullopt;
  Vector start = padded<D>(stress_point_place<T, D>(body, nearest, nearest_cell));
  for (int a = 0; a < D; ++a) start[a] += back[a];
  return start;
}

template <class T, int D>
double mean_value(const Body<T, D>& body, const MeasurementCase& m, double t) {
  double sum = 0, volume = 0;
  for_each_cell(body, [&](std::int64_t p, const Cell<D>& cell) {
    const double share = selected_share<T, D>(body, cell, m, t);
    if (share == 0) return;
    const StressPoint<D> point = stress_point<T, D>(body, p, cell);
    const double v = share * point.volume * point.volume_ratio;
    sum += v * cell_value<T, D>(body, p, cell, m.field);
    volume += v;
  });
  return volume > 0 ? sum / volume : no_value;
}

template double material_value(const Body<double, 2>&, const Vector&, const std::string&);
template std::optional<Vector> start_of(const Body<double, 2>&, const Vector&);
template double material_value(const Body<double, 3>&, const Vector&, const std::string&);
template std::optional<Vector> start_of(const Body<double, 3>&, const Vector&);
template double material_value(const Body<float, 2>&, const Vector&, const std::string&);
template std::optional<Vector> start_of(const Body<float, 2>&, const Vector&);
template double material_value(const Body<float, 3>&, const Vector&, const std::string&);
template std::optional<Vector> start_of(const Body<float, 3>&, const Vector&);
template double mean_value(const Body<double, 2>&, const MeasurementCase&, double);
template double mean_value(const Body<double, 3>&, const MeasurementCase&, double);
template double mean_value(const Body<float, 2>&, const MeasurementCase&, double);
template double mean_value(const Body<float, 3>&, const MeasurementCase&, double);

}  // namespace pliant::total_lagrangian

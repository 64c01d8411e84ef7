#include "engine/point_based/observe/node_values.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/geometry/padded.hpp"
#include "engine/method/field_components.hpp"
#include "engine/method/no_value.hpp"
#include "engine/method/polynomial_fit.hpp"
#include "engine/point_based/forces/node_state.hpp"

namespace pliant::point_based {

namespace {

template <class T, int D>
double node_value(const Body<T, D>& body, std::int64_t slot, const std::string& field) {
  const int axis = last_axis(field);
  if (field.starts_with("velocity")) return body.velocity[axis][slot];
  if (field.starts_with("displacement")) return body.displacement[axis][slot];
  const NodeState<D> node = node_state(body, body.block_of(slot), slot);
  if (field == "pressure") return node.pressure;
  if (field == "density") return body.material.density / node.volume_ratio;
  if (!field.starts_with("strain")) {
    return stress_value(full_stress<D>(node.stress, node.pressure), field);
  }
  std::array<Point<D>, D> gradient;
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) gradient[i][j] = node.gradient[D * i + j];
  }
  return strain_value<D>(gradient, field);
}

}  // namespace

template <class T, int D>
double material_value(const Body<T, D>& body, const Vector& start, std::int64_t nearest,
                      const std::string& field) {
  std::vector<std::int64_t> around = {nearest};
  body.for_each_bond(
      body.block_of(nearest), nearest,
      [&](int, std::int64_t other, const Point<D>&, double) { around.push_back(other); });
  const auto from_point = [&](std::int64_t slot) {
    Point<D> r;
    for (int a = 0; a < D; ++a) r[a] = body.start[slot][a] - start[a];
    return r;
  };
  const auto length = [](const Point<D>& r) {
    double square = 0;
    for (const double component : r) square += component * component;
    return std::sqrt(square);
  };
  double farthest = 0;
  for (const std::int64_t slot : around) farthest = std::max(farthest, length(from_point(slot)));
  constexpr double margin = 1.2;  // gives the farthest node a weight
  LinearFit<D, 1> fit;
  for (const std::int64_t slot : around) {
    Point<D> r = from_point(slot);
    for (double& component : r) component /= margin * farthest;
    const double rest = 1 - length(r) * length(r);
    fit.add(r, rest * rest, {node_value(body, slot, field)});
  }
  return fit.solve() ? fit.value(0) : node_value(body, nearest, field);
}

template <class T, int D>
double mean_value(const Body<T, D>& body, const MeasurementCase& m, double t) {
  double sum = 0, volume = 0;
  body.for_each_node([&](std::int64_t slot) {
    const Vector x = padded<D>(body.position(slot));
    if (m.where && (*m.where)(x[0], x[1], x[2], t) == 0) return;
    const NodeState<D> node = node_state(body, body.block_of(slot), slot);
    const double v = body.mass[slot] / body.material.density * node.volume_ratio;
    sum += v * node_value(body, slot, m.field);
    volume += v;
  });
  return volume > 0 ? sum / volume : no_value;
}

template <class T, int D>
Vector start_of(const Body<T, D>& body, const Vector& x) {
  double least = std::numeric_limits<double>::infinity();
  std::int64_t nearest = 0;
  Eigen::Matrix<double, D, 1> offset = Eigen::Matrix<double, D, 1>::Zero();
  body.for_each_node([&](std::int64_t slot) {
    const Point<D> at = body.position(slot);
    Eigen::Matrix<double, D, 1> r;
    for (int a = 0; a < D; ++a) r[a] = x[a] - at[a];
    if (r.squaredNorm() >= least) return;
    least = r.squaredNorm();
    nearest = slot;
    offset = r;
  });
  const std::array<double, D* D> f = present_gradient(body, body.block_of(nearest), nearest);
  const Eigen::Matrix<double, D, 1> back =
      Eigen::Map<const Eigen::Matrix<double, D, D, Eigen::RowMajor>>(f.data()).inverse() * offset;
  Vector start = padded<D>(body.start[nearest]);
  for (int a = 0; a < D; ++a) start[a] += back[a];
  return start;
}

template double material_value(const Body<double, 2>&, const Vector&, std::int64_t,
                               const std::string&);
template double material_value(const Body<double, 3>&, const Vector&, std::int64_t,
                               const std::string&);
template double material_value(const Body<float, 2>&, const Vector&, std::int64_t,
                               const std::string&);
template double material_value(const Body<float, 3>&, const Vector&, std::int64_t,
                               const std::string&);
template double mean_value(const Body<double, 2>&, const MeasurementCase&, double);
template double mean_value(const Body<double, 3>&, const MeasurementCase&, double);
template double mean_value(const Body<float, 2>&, const MeasurementCase&, double);
template double mean_value(const Body<float, 3>&, const MeasurementCase&, double);
template Vector start_of(const Body<double, 2>&, const Vector&);
template Vector start_of(const Body<double, 3>&, const Vector&);
template Vector start_of(const Body<float, 2>&, const Vector&);
template Vector start_of(const Body<float, 3>&, const Vector&);

}  // namespace pliant::point_based

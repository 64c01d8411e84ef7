#include "engine/point_based/observe/node_values.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/geometry/padded.hpp"
#include "engine/lattice/point_algebra.hpp"
#include "engine/method/field_components.hpp"
#include "engine/method/field_fit.hpp"
#include "engine/method/no_value.hpp"
#include "engine/method/region_share.hpp"
#include "engine/point_based/forces/node_gradient.hpp"
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

constexpr double margin = 1.2;       // gives the farthest node a weight
constexpr double coincident = 1e-9;  // distance of a point from a node, of that to the farthest one

/// A node, and the other ends of its bonds.
template <class T, int D>
std::vector<std::int64_t> with_neighbours(const Body<T, D>& body, std::int64_t node) {
  std::vector<std::int64_t> nodes = {node};
  body.for_each_bond(
      body.block_of(node), node,
      [&](int, std::int64_t other, const Point<D>&, double) { nodes.push_back(other); });
  return nodes;
}

/// The largest distance of the nodes from `place`, with a margin.
template <class T, int D>
double reach_of(const Body<T, D>& body, const std::vector<std::int64_t>& nodes,
                const Point<D>& place) {
  double farthest = 0;
  for (const std::int64_t slot : nodes) {
    farthest = std::max(farthest, norm<D>(difference<D>(body.start[slot], place)));
  }
  return margin * farthest;
}

}  // namespace

template <class T, int D>
double material_value(const Body<T, D>& body, const Vector& start, std::int64_t nearest,
                      const std::string& field) {
  const Point<D> place = unpadded<D>(start);
  const std::vector<std::int64_t> nodes = with_neighbours(body, nearest);
  const double reach = reach_of<T, D>(body, nodes, place);
  FieldFit<D> fit;
  for (const std::int64_t slot : nodes) {
    Point<D> r = difference<D>(body.start[slot], place);
    for (double& component : r) component /= reach;
    const double weight = weight_of_value(dot<D>(r, r), 1);
    fit.add(r, weight, weight, node_value(body, slot, field));
  }
  const std::optional<double> fitted = fit.value();
  return fitted ? *fitted : node_value(body, nearest, field);
}

// Where the gradient varies, that of the nearest node alone may be far from the one between the
// nodes.
template <class T, int D>
double point_displacement(const Body<T, D>& body, const Vector& start, std::int64_t nearest,
                          int axis, std::span<const CutSurface<D>> cuts) {
  const Point<D> place = unpadded<D>(start);
  std::vector<std::int64_t> nodes = with_neighbours(body, nearest);
  std::erase_if(nodes, [&](std::int64_t slot) {
    return slot != nearest && first_crossing<D>(body.start[slot], place, cuts);
  });
  const double reach = reach_of<T, D>(body, nodes, place);
  double sum = 0, weights = 0;
  for (const std::int64_t slot : nodes) {
    const Point<D> r = difference<D>(place, body.start[slot]);
    const double distance = norm<D>(r);
    double displacement = body.displacement[axis][slot];
    if (distance <= coincident * reach) return displacement;
    const NodeState<D> node = node_state(body, body.block_of(slot), slot);
    for (int a = 0; a < D; ++a) {
      displacement += (node.gradient[D * axis + a] - (a == axis ? 1 : 0)) * r[a];
    }
    const double weight = std::pow((reach - distance) / distance, 2);
    sum += weight * displacement;
    weights += weight;
  }
  return sum / weights;
}

namespace {

/// The cell of a node: a cube, of which the sides without neighbours are cut off at the node. Runs
/// from `lower` to `lower` + `sides` around the node in the undeformed body [m].
template <int D>
struct NodeCell {
  Point<D> lower, sides;
};

template <class T, int D>
NodeCell<D> cell_of(const Body<T, D>& body, std::int64_t slot, double volume) {
  constexpr double beside = 0.25;  // [H] a neighbour on this side of the node
  Point<D> below = {}, above = {};
  body.for_each_bond(body.block_of(slot), slot,
                     [&](int, std::int64_t other, const Point<D>&, double) {
                       const Point<D> way = difference<D>(body.start[other], body.start[slot]);
                       for (int a = 0; a < D; ++a) {
                         if (way[a] > beside * body.resolution) above[a] = 0.5;
                         if (way[a] < -beside * body.resolution) below[a] = 0.5;
                       }
                     });
  double share = 1;  // of the cube
  for (int a = 0; a < D; ++a) share *= std::max(below[a] + above[a], 0.5);
  const double size = std::pow(volume / share, 1. / D);
  NodeCell<D> cell;
  for (int a = 0; a < D; ++a) {
    cell.lower[a] = -below[a] * size;
    cell.sides[a] = (below[a] + above[a]) * size;
  }
  return cell;
}

/// The share of the cell of a node that a measurement selects.
template <class T, int D>
double selected_share(const Body<T, D>& body, std::int64_t slot, const MeasurementCase& m,
                      double t) {
  if (!m.where) return 1;
  const NodeCell<D> cell = cell_of<T, D>(body, slot, body.mass[slot] / body.material.density);
  const std::array<double, D* D> f = present_gradient(body, body.block_of(slot), slot);
  return share_in_region<D>(*m.where, t, [&](const Point<D>& r) {
    Point<D> x = body.position(slot);
    for (int a = 0; a < D; ++a) {
      for (int b = 0; b < D; ++b) x[a] += f[D * a + b] * (cell.lower[b] + r[b] * cell.sides[b]);
    }
    return x;
  });
}

}  // namespace

// What walls cover is rigid, (PB.21), and has neither stress nor strain.
template <class T, int D>
double mean_value(const Body<T, D>& body, const MeasurementCase& m, double t) {
  const bool deforms = m.field.starts_with("stress") || m.field.starts_with("strain") ||
                       m.field == "von_mises_stress" || m.field == "pressure";
  double sum = 0, volume = 0;
  body.for_each_node([&](std::int64_t slot) {
    const double share = selected_share(body, slot, m, t);
    if (share == 0) return;
    const double ratio = node_state(body, body.block_of(slot), slot).volume_ratio;
    const double v = share * body.mass[slot] / body.material.density * ratio;
    sum += (deforms ? share * body.volume[slot] * ratio : v) * node_value(body, slot, m.field);
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
template double point_displacement(const Body<double, 2>&, const Vector&, std::int64_t, int,
                                   std::span<const CutSurface<2>>);
template double mean_value(const Body<double, 2>&, const MeasurementCase&, double);
template double point_displacement(const Body<double, 3>&, const Vector&, std::int64_t, int,
                                   std::span<const CutSurface<3>>);
template double mean_value(const Body<double, 3>&, const MeasurementCase&, double);
template double point_displacement(const Body<float, 2>&, const Vector&, std::int64_t, int,
                                   std::span<const CutSurface<2>>);
template double mean_value(const Body<float, 2>&, const MeasurementCase&, double);
template double point_displacement(const Body<float, 3>&, const Vector&, std::int64_t, int,
                                   std::span<const CutSurface<3>>);
template double mean_value(const Body<float, 3>&, const MeasurementCase&, double);
template Vector start_of(const Body<double, 2>&, const Vector&);
template Vector start_of(const Body<double, 3>&, const Vector&);
template Vector start_of(const Body<float, 2>&, const Vector&);
template Vector start_of(const Body<float, 3>&, const Vector&);

}  // namespace pliant::point_based

#include "engine/point_based/forces/node_loads.hpp"

#include <Eigen/Dense>
#include <algorithm>

#include "engine/lattice/point_algebra.hpp"
#include "engine/point_based/forces/node_gradient.hpp"

namespace pliant::point_based {

namespace {

/// cof F a: the present area vector of an undeformed area a.
template <class T, int D>
Eigen::Matrix<double, D, 1> present_area(const Body<T, D>& body, const NodeBlock& block,
                                         const PressedNode<D>& node) {
  const auto f = present_gradient(body, block, node.slot);
  const Eigen::Map<const Eigen::Matrix<double, D, D, Eigen::RowMajor>> gradient(f.data());
  const Eigen::Map<const Eigen::Matrix<double, D, 1>> area(node.area.data());
  return gradient.determinant() * gradient.inverse().transpose() * area;
}

}  // namespace

template <class T, int D>
NodeLoads<T, D>::NodeLoads(State<T, D>& state, const Case& settings)
    : state_(state), gravity_(settings) {}

template <class T, int D>
bool NodeLoads<T, D>::act_on_blocks() const {
  return gravity_varies() || !state_.boundaries.pressures.empty() ||
         std::any_of(state_.bodies.begin(), state_.bodies.end(),
                     [](const Body<T, D>& body) { return !body.bladed.empty(); });
}

template <class T, int D>
void NodeLoads<T, D>::prepare(double time) {
  time_ = time;
  values_.evaluate(state_.boundaries, time);
  if (gravity_.acts() && gravity_.is_uniform()) {
    uniform_gravity_ = typename Gravity<D>::Now(gravity_, time)({});
  }
}

template <class T, int D>
void NodeLoads<T, D>::load(int block) {
  const auto [owner, local] = state_.blocks[block];
  Body<T, D>& body = state_.bodies[owner];
  const NodeBlock& range = body.blocks[local];
  for (int a = 0; a < D && !body.bladed.empty(); ++a) {
    std::fill_n(body.traction[a].get() + range.first, range.count, T(0));
  }
  for (const PressedNode<D>& node : body.pressed[local]) {
    for (int a = 0; a < D; ++a) {
      if (body.is_pressed()) body.pressure_load[a][node.slot] = T(0);
      if (body.is_loaded()) body.traction[a][node.slot] = T(0);
    }
  }
  if (gravity_varies()) {
    const typename Gravity<D>::Now gravity(gravity_, time_);
    for (std::int64_t slot = range.first; slot < range.first + range.nodes; ++slot) {
      const Point<D> g = gravity(body.position(slot));
      for (int a = 0; a < D; ++a) body.traction[a][slot] = static_cast<T>(body.mass[slot] * g[a]);
    }
  }
  for (PressedNode<D>& node : body.pressed[local]) press(body, range, node);
  if (body.bladed.empty()) return;
  for (const BladedNode<D>& node : body.bladed[local]) {
    for (int a = 0; a < D; ++a) body.traction[a][node.slot] += static_cast<T>(node.force[a]);
  }
}

// The kernel of bonds, if any, computes the force of a pressure from pressure times undeformed
// area; here the same force is stored for its power.
template <class T, int D>
void NodeLoads<T, D>::press(Body<T, D>& body, const NodeBlock& block, PressedNode<D>& node) const {
  const SurfacePressure<D>& load = state_.boundaries.pressures[node.pressure];
  const bool is_present = load.area() == BoundaryCase::LoadedArea::present;
  Point<D> x = node.middle;
  for (int a = 0; a < D && is_present; ++a) x[a] += body.displacement[a][node.slot];
  if (!load.is_traction()) {
    const double pressure = values_.pressure_at(node.pressure, x);
    const auto area = present_area(body, block, node);
    for (int a = 0; a < D; ++a) {
      node.force[a] = -pressure * area[a];
      if (body.is_pressed()) {
        body.pressure_load[a][node.slot] += static_cast<T>(pressure * node.area[a]);
      } else {
        body.traction[a][node.slot] += static_cast<T>(node.force[a]);
      }
    }
    return;
  }
  const Point<D> traction = values_.traction_at(node.pressure, x);
  double size = node.size;
  const double undeformed = norm<D>(node.area);  // 0 between opposite faces
  if (is_present && undeformed > 0) size *= present_area(body, block, node).norm() / undeformed;
  for (int a = 0; a < D; ++a) {
    node.force[a] = size * traction[a];
    body.traction[a][node.slot] += static_cast<T>(node.force[a]);
  }
}

template <class T, int D>
EnergyBudget NodeLoads<T, D>::power(int block) const {
  EnergyBudget power;
  const auto [owner, local] = state_.blocks[block];
  const Body<T, D>& body = state_.bodies[owner];
  double of_tractions = 0;
  for (const PressedNode<D>& node : body.pressed[local]) {
    double value = 0;
    for (int a = 0; a < D; ++a) value += node.force[a] * body.velocity[a][node.slot];
    power.load_work += value;
    const bool is_pressure = !state_.boundaries.pressures[node.pressure].is_traction();
    if (!is_pressure || !body.is_pressed()) of_tractions += value;
  }
  for (std::size_t i = 0; !body.bladed.empty() && i < body.bladed[local].size(); ++i) {
    const BladedNode<D>& node = body.bladed[local][i];
    for (int a = 0; a < D; ++a) power.blade_work += node.force[a] * body.velocity[a][node.slot];
  }
  if (!gravity_varies()) return power;
  of_tractions += power.blade_work;
  const NodeBlock& range = body.blocks[local];
  for (int a = 0; a < D; ++a) {
    const T* const velocity = body.velocity[a].get() + range.first;
    const T* const force = body.traction[a].get() + range.first;
    double sum = 0;
    for (int i = 0; i < range.nodes; ++i) sum += static_cast<double>(force[i]) * velocity[i];
    power.body_force_work += sum;
  }
  power.body_force_work -= of_tractions;
  return power;
}

template class NodeLoads<double, 2>;
template class NodeLoads<double, 3>;
template class NodeLoads<float, 2>;
template class NodeLoads<float, 3>;

}  // namespace pliant::point_based

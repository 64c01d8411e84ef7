#pragma once

#include <vector>

#include "engine/boundaries/boundary_values.hpp"
#include "engine/method/gravity.hpp"
#include "engine/point_based/state.hpp"

namespace pliant::point_based {

/// What pressures, tractions and gravity do to the nodes in a step, (PB.11), (PB.15), and their
/// power. Gravity that is the same everywhere is left to the kernels.
template <class T, int D>
class NodeLoads {
 public:
  NodeLoads(State<T, D>& state, const Case& settings);

  /// Whether blocks must be loaded in a step.
  bool act_on_blocks() const;
  /// Makes room for the present blocks.
  void prepare_blocks() { gravity_.reserve(state_.blocks.size()); }
  /// Sets the loads at `time` [s].
  void prepare(double time);
  /// The forces on the nodes of a block where these are at present.
  void load(int block);

  /// Gravity that is the same everywhere, else 0 [m/s^2].
  const Point<D>& uniform_gravity() const { return uniform_gravity_; }
  /// Of all loads on a block but such gravity, with the present velocities [W].
  EnergyBudget power(int block) const;

 private:
  bool gravity_varies() const { return gravity_.acts() && !gravity_.is_uniform(); }
  void press(Body<T, D>& body, const NodeBlock& block, PressedNode<D>& node) const;

  State<T, D>& state_;
  Gravity<D> gravity_;
  Point<D> uniform_gravity_ = {};
  BoundaryValues<D> values_;
  double time_ = 0;
};

extern template class NodeLoads<double, 2>;
extern template class NodeLoads<double, 3>;
extern template class NodeLoads<float, 2>;
extern template class NodeLoads<float, 3>;

}  // namespace pliant::point_based

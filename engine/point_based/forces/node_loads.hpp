#pragma once

#include <vector>

#include "engine/boundaries/boundary_values.hpp"
#include "engine/method/gravity.hpp"
#include "engine/point_based/state.hpp"

namespace pliant::point_based {

/// Forces of pressures, tractions and gravity on the nodes in a step, (PB.11), (PB.15), and their
/// power. Kernels apply uniform gravity.
template <class T, int D>
class NodeLoads {
 public:
  NodeLoads(State<T, D>& state, const Case& settings);

  /// Whether a step has to call `load` for its blocks.
  bool act_on_blocks() const;
  /// Sets the loads at `time` [s].
  void prepare(double time);
  /// Computes the forces on the nodes of a block at their present positions.
  void load(int block);

  /// Uniform gravity; 0 if gravity depends on the place [m/s^2].
  const Point<D>& uniform_gravity() const { return uniform_gravity_; }
  /// Power of all loads on a block at the present velocities, without uniform gravity [W].
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

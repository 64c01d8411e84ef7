#pragma once

#include <vector>

#include "engine/method/energy_budget.hpp"
#include "engine/method/gravity.hpp"
#include "engine/remeshed/state.hpp"

namespace pliant::remeshed {

/// The acceleration of the material of one block at one time, (RP.71).
template <int D>
struct BodyForce {
  typename Gravity<D>::Now gravity;
  double damping;
  bool acts;

  /// At `x`, of what moves with the velocity u [m/s^2].
  Point<D> operator()(const Point<D>& x, const Point<D>& u) const {
    Point<D> rate = gravity(x);
    for (int a = 0; a < D; ++a) rate[a] -= damping * u[a];
    return rate;
  }
};

/// Gravity and damping (RP.71). A stage leaves a state behind that depends on its rates linearly,
/// so that these rates can be added to it afterwards.
template <class T, int D>
class BodyForces {
 public:
  BodyForces(State<T, D>& state, const Case& settings);

  /// Fixes the time step [s].
  void prepare(double time_step);
  /// On the material of a block at a stage of the step.
  BodyForce<D> of(int block, int stage) const;
  /// Adds the rates of the particles of a block at a stage to the state that the stage has left
  /// behind.
  void advance(int block, int stage);
  /// Adds the work of the step to the state, block by block.
  void fold();
  /// [block] impulse of the step [N s].
  const std::vector<Point<D>>& impulse() const { return impulse_; }

 private:
  State<T, D>& state_;
  Gravity<D> gravity_;
  double damping_;
  double time_step_ = 0;
  std::vector<EnergyBudget> of_block_;  ///< [block], of the present step
  std::vector<Point<D>> impulse_;       ///< likewise
};

extern template class BodyForces<double, 2>;
extern template class BodyForces<double, 3>;
extern template class BodyForces<float, 2>;
extern template class BodyForces<float, 3>;

}  // namespace pliant::remeshed

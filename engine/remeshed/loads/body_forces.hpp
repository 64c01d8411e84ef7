#pragma once

#include <array>
#include <vector>

#include "engine/boundaries/wrench.hpp"
#include "engine/method/energy_budget.hpp"
#include "engine/method/gravity.hpp"
#include "engine/remeshed/state/state.hpp"

namespace pliant::remeshed {

/// The acceleration of the material at one time, (RP.71).
template <int D>
struct BodyForce {
  typename Gravity<D>::Now gravity;
  double mass_scaling;  ///< M of (RP.87): gravity acts only on the unscaled mass
  double damping;
  bool acts;

  /// Acceleration by gravity at `x` [m/s^2].
  Point<D> of_gravity(const Point<D>& x) const {
    Point<D> rate = gravity(x);
    for (double& component : rate) component /= mass_scaling;
    return rate;
  }
  /// Acceleration at `x` of material with the velocity u [m/s^2].
  Point<D> operator()(const Point<D>& x, const Point<D>& u) const {
    Point<D> rate = of_gravity(x);
    for (int a = 0; a < D; ++a) rate[a] -= damping * u[a];
    return rate;
  }
};

/// Sums of body forces on the particles of a block at one stage, and of these particles; moments
/// are about the origin.
template <int D>
struct ForceOnBlock {
  double mass = 0;
  Point<D> first_moment = {};
  Wrench<D> force;
};

/// Gravity and damping (RP.71), and the shear of tractions (RP.107). The state that a stage writes
/// depends linearly on its rates, so these rates can be added to it afterwards.
template <class T, int D>
class BodyForces {
 public:
  BodyForces(State<T, D>& state, const Case& settings);

  /// Sets the time step [s].
  void prepare(double time_step);
  /// The body force at a stage of the step.
  BodyForce<D> at(int stage) const;
  /// Adds the rates of the particles of a block at a stage to the state that the stage has written.
  void advance(int block, int stage);
  /// Adds the work of the step to the state, block by block, and adapts the damping rate to the
  /// motion.
  void fold();
  /// [block] impulse of gravity and damping in the step [N s].
  const std::vector<Point<D>>& impulse() const { return impulse_; }
  /// [block][stage] of the step; zero mass if none acts.
  const std::vector<std::array<ForceOnBlock<D>, 4>>& forces() const { return forces_; }

 private:
  /// Sums over the particles of a block in the first two stages, before body forces act, for
  /// (RP.88).
  struct Motion {
    double inertia = 0;               ///< sum m u.u [J]
    std::array<double, 2> gain = {};  ///< [stage] sum m u.(du of the stage) [J]
  };
  void follow(int block, int stage);
  void apply_field(int block, int stage, const BodyForce<D>& force_of);
  void apply_shear(int block, int stage);
  void adapt_damping();

  State<T, D>& state_;
  Gravity<D> gravity_;
  double mass_scaling_;
  bool is_adaptive_;  ///< whether the damping rate is adaptive, (RP.88)
  double time_step_ = 0;
  std::vector<EnergyBudget> of_block_;                  ///< [block], of the present step
  std::vector<Point<D>> impulse_;                       ///< likewise
  std::vector<std::array<ForceOnBlock<D>, 4>> forces_;  ///< likewise
  std::vector<Motion> motion_;                          ///< likewise
};

extern template class BodyForces<double, 2>;
extern template class BodyForces<double, 3>;
extern template class BodyForces<float, 2>;
extern template class BodyForces<float, 3>;

}  // namespace pliant::remeshed

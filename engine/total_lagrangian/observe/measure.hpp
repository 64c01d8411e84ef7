#pragma once

#include <vector>

#include "engine/total_lagrangian/state.hpp"
#include "engine/undeformed/measurer.hpp"
#include "scheduler/workers.hpp"

namespace pliant::total_lagrangian {

/// Evaluates measurements of a state at one time. Momentum and kinetic energy include mass scaling.
template <class T, int D>
class Measurer final : public undeformed::Measurer<State<T, D>> {
 public:
  Measurer(const State<T, D>& state, scheduler::Workers& workers)
      : Base(state), state_(state), workers_(workers) {}

 private:
  using Base = undeformed::Measurer<State<T, D>>;

  undeformed::FreeSurface<D> free_surface(int body) const override;
  BodyIntegrals integrals(int body, const Vector& about) const override;
  /// After particles have moved on by a time [s] at their velocities.
  double strain_energy(const Body<T, D>& body, double ahead) const;
  /// (TL.30)
  double total_energy(int body, const BodyIntegrals& sum) const override;
  double point_displacement(const MeasurementCase& m) const override;
  double point_value(const MeasurementCase& m) const override;
  double material_value(const MeasurementCase& m) const override;
  double mean_value(const MeasurementCase& m) const override;
  double velocity_error(const MeasurementCase& m) const override;
  /// The field of a measurement at a place of the undeformed body.
  double value_at(const MeasurementCase& m, const Vector& start) const;
  std::vector<Point<D>> present_velocity(const Body<T, D>& body) const;
  /// Power of loads, walls and damping on a body [W].
  double power_on(const Body<T, D>& body) const;

  const State<T, D>& state_;
  scheduler::Workers& workers_;
};

}  // namespace pliant::total_lagrangian

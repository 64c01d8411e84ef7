#pragma once

#include <vector>

#include "engine/total_lagrangian/state.hpp"
#include "engine/undeformed/measurer.hpp"

namespace pliant::total_lagrangian {

/// Evaluates measurements of a state at one instant. Momentum and kinetic energy are those of the
/// scaled mass, as the particles have them.
template <class T, int D>
class Measurer final : public undeformed::Measurer<State<T, D>> {
 public:
  Measurer(const Case& settings, const State<T, D>& state)
      : Base(state), settings_(settings), state_(state) {}

  static bool is_measured(MeasurementCase::Kind kind) {
    return Base::is_common(kind) || function_of(kind) != nullptr;
  }

 private:
  using Base = undeformed::Measurer<State<T, D>>;

  double own_value(const MeasurementCase& m) const override;
  undeformed::FreeSurface<D> free_surface(int body) const override;
  BodyIntegrals integrals(int body, const Vector& about) const override;

  using Function = double (Measurer::*)(const MeasurementCase&) const;
  /// The function that evaluates a kind that not all methods find alike; null where there is none.
  static Function function_of(MeasurementCase::Kind kind);
  double point_displacement(const MeasurementCase& m) const;
  double point_value(const MeasurementCase& m) const;
  double material_value(const MeasurementCase& m) const;
  double mean_value(const MeasurementCase& m) const;
  double velocity_error(const MeasurementCase& m) const;
  /// The field of a measurement at a place of the undeformed body.
  double value_at(const MeasurementCase& m, const Vector& start) const;
  std::vector<Point<D>> present_velocity(const Body<T, D>& body) const;

  const Case& settings_;
  const State<T, D>& state_;
};

}  // namespace pliant::total_lagrangian

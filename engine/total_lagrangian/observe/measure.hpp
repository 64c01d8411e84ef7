#pragma once

#include <span>
#include <vector>

#include "engine/method/body_integrals.hpp"
#include "engine/total_lagrangian/state.hpp"
#include "engine/undeformed/surface_measures.hpp"

namespace pliant::total_lagrangian {

/// Evaluates measurements of a state at one instant.
template <class T, int D>
class Measurer {
 public:
  Measurer(const Case& settings, const State<T, D>& state) : settings_(settings), state_(state) {}

  /// One value for each measurement; NaN where it has none (those which read histories).
  std::vector<double> operator()(std::span<const MeasurementCase> measurements) const;

  /// Of all bodies together. Momentum and kinetic energy are those of the scaled mass, as the
  /// particles have them.
  BodyIntegrals totals() const;

  static bool is_measured(MeasurementCase::Kind kind) { return function_of(kind) != nullptr; }

 private:
  using Function = double (Measurer::*)(const MeasurementCase&) const;
  /// The function that evaluates a kind of measurement; null where there is none.
  static Function function_of(MeasurementCase::Kind kind);
  double value(const MeasurementCase& m) const;
  double extent(const MeasurementCase& m) const;
  double surface_distance(const MeasurementCase& m) const;
  double mean_radius(const MeasurementCase& m) const;
  double point_displacement(const MeasurementCase& m) const;
  double point_value(const MeasurementCase& m) const;
  double wall_impulse(const MeasurementCase& m) const;
  double material_value(const MeasurementCase& m) const;
  double mean_value(const MeasurementCase& m) const;
  double surface_area(const MeasurementCase& m) const;
  double velocity_error(const MeasurementCase& m) const;
  double integral(const MeasurementCase& m) const;
  undeformed::FreeSurface<D> free_surface(int body) const;
  /// The field of a measurement at a place of the undeformed body.
  double value_at(const MeasurementCase& m, const Vector& start) const;
  std::vector<Point<D>> present_velocity(const Body<T, D>& body) const;
  BodyIntegrals integrals(int body, const Vector& about) const;

  const Case& settings_;
  const State<T, D>& state_;
};

}  // namespace pliant::total_lagrangian

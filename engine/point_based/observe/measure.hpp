#pragma once

#include <cstdint>
#include <optional>

#include "engine/point_based/state.hpp"
#include "engine/undeformed/measurer.hpp"

namespace pliant::point_based {

/// Evaluates measurements of a state at one time.
template <class T, int D>
class Measurer : public undeformed::Measurer<State<T, D>> {
 public:
  explicit Measurer(const State<T, D>& state) : Base(state), state_(state) {}

  static bool is_measured(MeasurementCase::Kind kind) {
    return Base::is_measured(kind) || function_of(kind) != nullptr;
  }

 private:
  using Base = undeformed::Measurer<State<T, D>>;

  /// Adds the present volume and the strain energy of a body.
  virtual void add_strain(int body, BodyIntegrals& sum) const;

  double own_value(const MeasurementCase& m) const override;
  undeformed::FreeSurface<D> free_surface(int body) const override;
  BodyIntegrals integrals(int body, const Vector& about) const override;
  double point_displacement(const MeasurementCase& m) const override;
  double point_value(const MeasurementCase& m) const override;
  double material_value(const MeasurementCase& m) const override;
  double mean_value(const MeasurementCase& m) const override;
  double velocity_error(const MeasurementCase& m) const override;

  using Function = double (Measurer::*)(const MeasurementCase&) const;
  /// The function of a measurement kind that only this method has; null for all others.
  static Function function_of(MeasurementCase::Kind kind);
  double blade_impulse(const MeasurementCase& m) const;
  double cutting_work(const MeasurementCase& m) const;
  double parts(const MeasurementCase& m) const;

  /// Slot of the node nearest to a point of the undeformed body, on the same side of all cuts; none
  /// outside the body.
  std::optional<std::int64_t> nearest_node(int body, const Vector& point) const;
  /// The field of a measurement at a place of the undeformed body.
  double value_at(const MeasurementCase& m, const Vector& start) const;

  const State<T, D>& state_;
};

}  // namespace pliant::point_based

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/method/body_integrals.hpp"
#include "engine/point_based/state.hpp"
#include "engine/undeformed/surface_measures.hpp"

namespace pliant::point_based {

/// Evaluates measurements of a state at one instant.
template <class T, int D>
class Measurer {
 public:
  explicit Measurer(const State<T, D>& state) : state_(state) {}
  virtual ~Measurer() = default;

  /// One value for each measurement; NaN where it has none (those which read histories).
  std::vector<double> operator()(std::span<const MeasurementCase> measurements) const;

  /// Of all bodies together.
  BodyIntegrals totals() const;

  static bool is_measured(MeasurementCase::Kind kind) { return function_of(kind) != nullptr; }

 private:
  /// Adds the present volume and the strain energy of a body.
  virtual void add_strain(int body, BodyIntegrals& sum) const;

  using Function = double (Measurer::*)(const MeasurementCase&) const;
  /// The function that evaluates a kind of measurement; null where there is none.
  static Function function_of(MeasurementCase::Kind kind);
  double value(const MeasurementCase& m) const;
  double extent(const MeasurementCase& m) const;
  double surface_distance(const MeasurementCase& m) const;
  double mean_radius(const MeasurementCase& m) const;
  double point_displacement(const MeasurementCase& m) const;
  double point_value(const MeasurementCase& m) const;
  double material_value(const MeasurementCase& m) const;
  double mean_value(const MeasurementCase& m) const;
  double wall_impulse(const MeasurementCase& m) const;
  double blade_impulse(const MeasurementCase& m) const;
  double cutting_work(const MeasurementCase& m) const;
  double surface_area(const MeasurementCase& m) const;
  double parts(const MeasurementCase& m) const;
  double velocity_error(const MeasurementCase& m) const;
  double integral(const MeasurementCase& m) const;
  BodyIntegrals integrals(int body, const Vector& about) const;

  /// The present free surface of a body, cut faces left out.
  undeformed::FreeSurface<D> free_surface(int body) const;
  /// Slot of the node of the undeformed body that is nearest to a point on its side of all cuts; none
  /// where the point lies outside.
  std::optional<std::int64_t> nearest_node(int body, const Vector& point) const;
  /// The field of a measurement at a place of the undeformed body.
  double value_at(const MeasurementCase& m, const Vector& start) const;

  const State<T, D>& state_;
};

}  // namespace pliant::point_based

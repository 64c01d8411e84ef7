#pragma once

#include <span>
#include <utility>
#include <vector>

#include "engine/method/body_integrals.hpp"
#include "engine/point_based/cutting/cut_surface.hpp"
#include "engine/point_based/state.hpp"

namespace pliant::point_based {

/// Evaluates measurements of a state at one instant.
template <class T, int D>
class Measurer {
 public:
  /// `cuts` are those of each body, empty where there are none.
  explicit Measurer(const State<T, D>& state, std::vector<std::span<const CutSurface<D>>> cuts = {})
      : state_(state), cuts_(std::move(cuts)) {}
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
  double point_displacement(const MeasurementCase& m) const;
  double wall_impulse(const MeasurementCase& m) const;
  double blade_impulse(const MeasurementCase& m) const;
  double cutting_work(const MeasurementCase& m) const;
  double surface_area(const MeasurementCase& m) const;
  double parts(const MeasurementCase& m) const;
  double integral(const MeasurementCase& m) const;
  BodyIntegrals integrals(int body, const Vector& about) const;

  /// Whether a cut runs between two places of the undeformed body.
  bool is_cut_off(int body, const Point<D>& node, const Point<D>& x) const;

  const State<T, D>& state_;
  std::vector<std::span<const CutSurface<D>>> cuts_;  ///< [body]
};

}  // namespace pliant::point_based

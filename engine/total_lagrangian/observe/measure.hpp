#pragma once

#include <vector>

#include "engine/method/body_integrals.hpp"
#include "engine/total_lagrangian/solver.hpp"

namespace pliant::total_lagrangian {

/// Evaluates what a case measures at the present time of a solver.
template <class T, int D>
class Measurer {
 public:
  explicit Measurer(Solver<T, D>& solver) : solver_(solver) {}

  /// One value for each measurement of the case; NaN where it has none (those which read
  /// histories).
  std::vector<double> operator()();

  /// Of all bodies together. Momentum and kinetic energy are those of the scaled mass, as the
  /// particles have them.
  BodyIntegrals totals();

 private:
  double value(const MeasurementCase& m) const;
  double extent(const MeasurementCase& m) const;
  double point_displacement(const MeasurementCase& m) const;
  double surface_area(const MeasurementCase& m) const;
  BodyIntegrals integrals(int body, const Vector& about) const;

  Solver<T, D>& solver_;
};

}  // namespace pliant::total_lagrangian

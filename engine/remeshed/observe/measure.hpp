#pragma once

#include <string>
#include <vector>

#include "engine/remeshed/observe/integrals.hpp"
#include "engine/remeshed/solver.hpp"

namespace pliant::remeshed {

/// Evaluates what a case measures at the present time of a solver.
template <class T, int D>
class Measurer {
 public:
  explicit Measurer(Solver<T, D>& solver) : solver_(solver) {}

  /// One value for each measurement of the case; NaN where it has none (those which read histories,
  /// and surfaces that do not exist). Of forces, the impulse since t = 0: histories tell the
  /// force.
  std::vector<double> operator()();

  /// Conserved quantities of all bodies together, as the summary reports them.
  BodyIntegrals totals();

 private:
  double value(const MeasurementCase& m);
  double impulse(const MeasurementCase& m) const;
  double surface_value(const MeasurementCase& m);
  double velocity_error(const MeasurementCase& m) const;
  double point_value(const MeasurementCase& m);
  /// Integrals of a body; its angular momentum is about `about`.
  struct Integrated {
    int body;
    Vector about;
    BodyIntegrals sum;
  };
  const BodyIntegrals& integrals(int body, const Vector& about);
  BodyIntegrals integrate_body(int body, const Vector& about);
  const LatticeView<T, D>& nodes(int body);
  void clear();

  Solver<T, D>& solver_;
  // Of the present call, once something asks for them.
  std::vector<LatticeView<T, D>> nodes_;
  std::vector<Integrated> integrals_;
};

/// Displacement since t = 0 of the material point that started at `start` [m]: the linear fit
/// through the particles that started around it.
template <class T, int D>
Vector material_displacement(const Body<T, D>& body, const Vector& start);

}  // namespace pliant::remeshed

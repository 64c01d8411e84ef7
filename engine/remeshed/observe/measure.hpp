#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "engine/method/integrals_once.hpp"
#include "engine/remeshed/observe/integrals.hpp"
#include "engine/remeshed/state/lattice_view.hpp"
#include "engine/remeshed/state/state.hpp"

namespace pliant::remeshed {

/// Evaluates measurements of a state at one time. Common intermediate results are computed once.
template <class T, int D>
class Measurer {
 public:
  /// Without `find_nodes`, conserved quantities are sums over particles, and nothing else that
  /// needs nodes can be measured.
  Measurer(const Case& settings, const State<T, D>& state, scheduler::Workers& workers,
           NodeSource<T, D> find_nodes)
      : settings_(settings), state_(state), workers_(workers), find_nodes_(std::move(find_nodes)) {}

  /// One value for each measurement, as in Solver::measure.
  std::vector<double> operator()(std::span<const MeasurementCase> measurements);

  /// Conserved quantities of all bodies together, for the summary.
  BodyIntegrals totals();

  /// [body] from `find_nodes`.
  const std::vector<LatticeView<T, D>>& nodes();

  static bool is_measured(MeasurementCase::Kind kind) {
    return function_of(kind).evaluate != nullptr;
  }
  /// Whether a measurement needs only particles, neither nodes nor a level set.
  static bool is_measured_on_particles(MeasurementCase::Kind kind) {
    return is_measured(kind) && function_of(kind).reads == Reads::particles;
  }

 private:
  enum class Reads { particles, nodes };
  struct Function {
    MeasurementCase::Kind kind = {};
    double (Measurer::*evaluate)(const MeasurementCase&) = nullptr;  ///< null: none
    Reads reads = Reads::particles;
  };
  static Function function_of(MeasurementCase::Kind kind);
  double value(const MeasurementCase& m);
  // One function for each kind of measurement, or for several similar kinds.
  double extent(const MeasurementCase& m);
  double surface_distance(const MeasurementCase& m);
  double mean_radius(const MeasurementCase& m);
  double point_displacement(const MeasurementCase& m);
  double point_value(const MeasurementCase& m);
  double material_value(const MeasurementCase& m);
  double mean_value(const MeasurementCase& m);
  double integral(const MeasurementCase& m);
  double wall_impulse(const MeasurementCase& m);
  double wall_angular_impulse(const MeasurementCase& m);
  double contact_impulse(const MeasurementCase& m);
  double area(const MeasurementCase& m);
  double minimum_particle_distance(const MeasurementCase& m);
  double velocity_error(const MeasurementCase& m);
  /// Whether a point of the surface counts: outside walls, and where the measurement selects it.
  std::function<bool(const Vector&)> free_points(const MeasurementCase& m) const;
  /// Whether a point lies in a wall to which bodies are attached.
  bool is_in_wall(const Vector& x) const;
  /// Integrals of a body; its angular momentum is about `about`.
  const BodyIntegrals& integrals(int body, const Vector& about);
  BodyIntegrals integrate_body(int body, const Vector& about);

  const Case& settings_;
  const State<T, D>& state_;
  scheduler::Workers& workers_;
  NodeSource<T, D> find_nodes_;
  std::vector<LatticeView<T, D>> nodes_;  ///< empty until first needed
  IntegralsOnce integrals_;
};

}  // namespace pliant::remeshed

#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/remeshed/lattice_view.hpp"
#include "engine/remeshed/observe/integrals.hpp"
#include "engine/remeshed/state.hpp"

namespace pliant::remeshed {

/// Evaluates measurements of a state at one instant. What several of them need is found once.
template <class T, int D>
class Measurer {
 public:
  /// Without `find_nodes` conserved quantities are sums over particles, and nothing else that is
  /// found on nodes can be measured.
  Measurer(const Case& settings, const State<T, D>& state, NodeSource<T, D> find_nodes)
      : settings_(settings), state_(state), find_nodes_(std::move(find_nodes)) {}

  /// One value for each measurement; NaN where it has none (those which read histories, and
  /// surfaces that do not exist). Of forces, the impulse since t = 0: histories tell the force.
  std::vector<double> operator()(std::span<const MeasurementCase> measurements);

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

  const Case& settings_;
  const State<T, D>& state_;
  NodeSource<T, D> find_nodes_;
  // Empty until something asks for them.
  std::vector<LatticeView<T, D>> nodes_;
  std::vector<Integrated> integrals_;
};

/// Displacement since t = 0 of the material point that started at `start` [m]: the linear fit
/// through the particles that started around it.
template <class T, int D>
Vector material_displacement(const Body<T, D>& body, const Vector& start);

}  // namespace pliant::remeshed

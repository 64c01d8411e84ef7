#pragma once

#include <span>
#include <utility>
#include <vector>

#include "engine/method/integrals_once.hpp"
#include "engine/method/no_value.hpp"
#include "engine/undeformed/state.hpp"
#include "engine/undeformed/surface_measures.hpp"

namespace pliant::undeformed {

/// Evaluates measurements of a state at one time: those that all methods on the undeformed body
/// have. A method supplies the details and adds its own measurements.
template <class State>
class Measurer {
 public:
  explicit Measurer(const State& state) : state_(state) {}
  virtual ~Measurer() = default;

  /// One value for each measurement; NaN for those that evaluate histories.
  std::vector<double> operator()(std::span<const MeasurementCase> measurements) const;

  BodyIntegrals totals() const;

  /// Whether all methods on the undeformed body have a kind of measurement.
  static bool is_measured(MeasurementCase::Kind kind) { return function_of(kind) != nullptr; }

 protected:
  static constexpr int D = decltype(State::bodies)::value_type::dimension;

 private:
  virtual double point_displacement(const MeasurementCase& m) const = 0;
  virtual double point_value(const MeasurementCase& m) const = 0;
  virtual double material_value(const MeasurementCase& m) const = 0;
  virtual double mean_value(const MeasurementCase& m) const = 0;
  virtual double velocity_error(const MeasurementCase& m) const = 0;
  /// The value of a kind that only this method has; `no_value` for all others.
  virtual double own_value(const MeasurementCase&) const { return no_value; }
  /// The present free surface of a body, without cut faces.
  virtual FreeSurface<D> free_surface(int body) const = 0;
  /// Integrals of a body; its angular momentum is about `about`.
  virtual BodyIntegrals integrals(int body, const Vector& about) const = 0;
  /// The total energy of a body as its steps conserve it; `sum` are its integrals.
  virtual double total_energy(int, const BodyIntegrals& sum) const {
    return sum.kinetic_energy + sum.strain_energy;
  }

  using Function = double (Measurer::*)(const MeasurementCase&) const;
  static Function function_of(MeasurementCase::Kind kind);
  double extent(const MeasurementCase& m) const {
    return undeformed::extent<D>(free_surface(m.body), m, state_.clock.time);
  }
  double surface_distance(const MeasurementCase& m) const {
    return undeformed::surface_distance<D>(free_surface(m.body), m);
  }
  double mean_radius(const MeasurementCase& m) const {
    return undeformed::mean_radius<D>(free_surface(m.body), m);
  }
  double surface_area(const MeasurementCase& m) const {
    return undeformed::surface_area<D>(free_surface(m.body));
  }
  double wall_impulse(const MeasurementCase& m) const {
    return state_.impulse_of_wall(m).force[m.axis];
  }
  double wall_angular_impulse(const MeasurementCase& m) const {
    return state_.impulse_of_wall(m).moment_about(m.point)[D == 2 ? 2 : m.axis];
  }
  double contact_impulse(const MeasurementCase& m) const {
    return state_.contact_impulse_on_first(m);
  }
  /// `integrals`, computed once for all measurements.
  const BodyIntegrals& integrals_once(int body, const Vector& about) const;
  double integral(const MeasurementCase& m) const {
    const BodyIntegrals& sum = integrals_once(m.body, m.point);
    const bool is_total = m.kind == MeasurementCase::Kind::total_energy;
    return is_total ? total_energy(m.body, sum) : value_of(m, sum, D);
  }

  const State& state_;
  mutable IntegralsOnce integrals_once_;
};

template <class State>
std::vector<double> Measurer<State>::operator()(
    std::span<const MeasurementCase> measurements) const {
  std::vector<double> values;
  values.reserve(measurements.size());
  for (const MeasurementCase& m : measurements) {
    const Function function = function_of(m.kind);
    values.push_back(function ? (this->*function)(m) : own_value(m));
  }
  return values;
}

template <class State>
auto Measurer<State>::function_of(MeasurementCase::Kind kind) -> Function {
  using Quantity = MeasurementCase::Kind;
  static constexpr std::pair<Quantity, Function> functions[] = {
      {Quantity::point_displacement, &Measurer::point_displacement},
      {Quantity::point_value, &Measurer::point_value},
      {Quantity::material_value, &Measurer::material_value},
      {Quantity::mean_value, &Measurer::mean_value},
      {Quantity::velocity_error, &Measurer::velocity_error},
      {Quantity::extent, &Measurer::extent},
      {Quantity::surface_distance, &Measurer::surface_distance},
      {Quantity::mean_radius, &Measurer::mean_radius},
      {Quantity::surface_area, &Measurer::surface_area},
      {Quantity::wall_force, &Measurer::wall_impulse},
      {Quantity::wall_moment, &Measurer::wall_angular_impulse},
      {Quantity::contact_force, &Measurer::contact_impulse},
      {Quantity::mass, &Measurer::integral},
      {Quantity::centre_of_mass, &Measurer::integral},
      {Quantity::momentum, &Measurer::integral},
      {Quantity::angular_momentum, &Measurer::integral},
      {Quantity::kinetic_energy, &Measurer::integral},
      {Quantity::strain_energy, &Measurer::integral},
      {Quantity::total_energy, &Measurer::integral},
      {Quantity::energy_ratio, &Measurer::integral},
      {Quantity::volume, &Measurer::integral},
  };
  for (const auto& [known, function] : functions) {
    if (known == kind) return function;
  }
  return nullptr;
}

template <class State>
const BodyIntegrals& Measurer<State>::integrals_once(int body, const Vector& about) const {
  return integrals_once_.of(body, about, [&] { return integrals(body, about); });
}

template <class State>
BodyIntegrals Measurer<State>::totals() const {
  BodyIntegrals sum;
  for (int b = 0; b < static_cast<int>(state_.bodies.size()); ++b) add(sum, integrals_once(b, {}));
  return sum;
}

}  // namespace pliant::undeformed

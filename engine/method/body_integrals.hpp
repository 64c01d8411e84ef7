#pragma once

#include "engine/case/case.hpp"

namespace pliant {

/// Integrals over a body, in SI units, per unit thickness in 2D. Momentum, angular momentum and
/// kinetic energy include mass scaling.
struct BodyIntegrals {
  double volume = 0;
  double mass = 0;
  Vector first_moment = {};  ///< of the mass, about `about`
  Vector momentum = {};
  Vector angular_momentum = {};  ///< about `about`; z alone in 2D
  double kinetic_energy = 0;
  double strain_energy = 0;
};

/// The value of a measurement that is one of the integrals; for every other kind, the total energy.
double value_of(const MeasurementCase& measurement, const BodyIntegrals& sum, int dimension);

/// Adds the first moment, momentum, angular momentum and kinetic energy of a mass [kg]. `r` [m] is
/// its place relative to the point about which moments are taken, `u` [m/s] its velocity; its
/// inertia is `mass_scaling` times its mass.
void add_motion(BodyIntegrals& sum, double mass, const Vector& r, const Vector& u,
                double mass_scaling = 1);

void add(BodyIntegrals& sum, const BodyIntegrals& other);

}  // namespace pliant

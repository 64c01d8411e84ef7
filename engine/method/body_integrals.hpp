#pragma once

#include "engine/case/case.hpp"

namespace pliant {

/// Integrals over a body, in SI units, per unit thickness in 2D. Momenta and kinetic energy are
/// those of the scaled mass.
struct BodyIntegrals {
  double volume = 0;
  double mass = 0;
  Vector first_moment = {};  ///< of the mass, from `about`
  Vector momentum = {};
  Vector angular_momentum = {};  ///< about `about`; z alone in 2D
  double kinetic_energy = 0;
  double strain_energy = 0;
};

/// What a measurement of an integral takes from them; total energy for kinds of another sort.
double value_of(const MeasurementCase& measurement, const BodyIntegrals& sum, int dimension);

/// Adds the first moment, the momenta and the kinetic energy of `mass` [kg] at `r` [m], seen from
/// the point that angular momentum is about, with velocity `u` [m/s] and `mass_scaling` times the
/// inertia of the mass.
void add_motion(BodyIntegrals& sum, double mass, const Vector& r, const Vector& u,
                double mass_scaling = 1);

/// Adds those of another body.
void add(BodyIntegrals& sum, const BodyIntegrals& other);

}  // namespace pliant

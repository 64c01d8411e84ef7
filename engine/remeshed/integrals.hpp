#pragma once

#include "engine/remeshed/solver.hpp"

namespace pliant::remeshed {

/// Integrals over one body, SI units per unit thickness in 2D.
struct BodyIntegrals {
  double volume = 0;
  double mass = 0;
  Vector momentum = {};
  Vector angular_momentum = {};  ///< about `about`; z alone in 2D
  double kinetic_energy = 0;
  double strain_energy = 0;
};

/// Over {phi < 0} in front of every wall, (RP.31), (RP.40)-(RP.42).
template <class T, int D>
BodyIntegrals integrate(const LatticeView<T, D>& view, const Boundaries<D>& boundaries,
                        const Vector& about);

/// As sums over the particles, for bodies that are never remeshed or have no surface.
template <class T, int D>
BodyIntegrals sum_particles(const Body<T, D>& body, const Vector& about);

}  // namespace pliant::remeshed

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/undeformed/body.hpp"

namespace pliant::undeformed {

/// The stiffness and the inertia of the motion since the last sample, (TL.10): sums over particles
/// with the displacement D since then.
struct Secant {
  double stiffness = 0;  ///< D.(F' - F), F' the internal forces at the last sample [J]
  double inertia = 0;    ///< D.m D, without mass scaling [kg m^2]

  Secant& operator+=(const Secant& other) {
    stiffness += other.stiffness;
    inertia += other.inertia;
    return *this;
  }
  /// The Rayleigh quotient, 0 where the stiffness is negative [1/s^2].
  double frequency2() const { return stiffness > 0 && inertia > 0 ? stiffness / inertia : 0; }
};

/// Compares the particles of some slots with the last sample, and replaces it. `displacement` and
/// `force` return the present components (axis, slot).
template <class T, int D, class Displacement, class Force>
Secant take_sample(Body<T, D>& body, std::int64_t first, std::int64_t count,
                   const Displacement& displacement, const Force& force) {
  Secant secant;
  for (std::int64_t slot = first; slot < first + count; ++slot) {
    if (!body.is_particle(slot)) continue;
    double square = 0;
    for (int a = 0; a < D; ++a) {
      T& last_displacement = body.sampled_displacement[a][slot];
      T& last_force = body.sampled_force[a][slot];
      const T d = displacement(a, slot), f = force(a, slot);
      const double moved = double{d} - last_displacement;
      secant.stiffness += moved * (double{last_force} - f);
      square += moved * moved;
      last_displacement = d;
      last_force = f;
    }
    secant.inertia += body.mass[slot] * square;
  }
  return secant;
}

/// Steps until the next sample after one that has found the frequency `omega` [1/s], `last` steps
/// after that before, (TL.10). Samples are so far apart that what rounding to T adds to
/// displacements and forces is small beside the motion.
template <class T>
std::int64_t steps_until_sample(double omega, double time_step, std::int64_t last) {
  constexpr double radians = sizeof(T) == sizeof(float) ? 0.2 : 0.02;
  constexpr std::int64_t most = 512;
  const double steps = radians / std::max(omega * time_step, radians / most);
  return std::clamp(static_cast<std::int64_t>(steps), std::int64_t{1}, std::min(2 * last, most));
}

}  // namespace pliant::undeformed

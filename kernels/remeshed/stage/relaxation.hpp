#pragma once

#include <cmath>

#include "kernels/layout.hpp"
#include "kernels/remeshed/stage/arguments.hpp"

/// Prony terms in plain scalars, for the preparation of steps and for measurements.
namespace pliant::kernels {

/// (RP.22) over `interval` [s]. It is exact if J is linear in time, for any ratio of interval to
/// tau.
template <class T>
Relaxation<T> relaxation(const PronyTerm<T>& term, T instantaneous_bulk_modulus, double interval) {
  const double a = interval / term.time;
  const double decay = std::exp(-a);
  const double mean = a > 0 ? -std::expm1(-a) / a : 1;  // mean of exp(-s/tau) over the interval
  const double modulus = term.ratio * instantaneous_bulk_modulus;
  return {static_cast<T>(decay), static_cast<T>(modulus * (mean - decay)),
          static_cast<T>(modulus * (1 - mean))};
}

/// The contribution of one term to the elastic energy per reference volume at J - 1 =
/// `volume_change`, (RP.64).
template <class T>
T relaxed_energy(const PronyTerm<T>& term, T instantaneous_bulk_modulus, T pressure,
                 T volume_change) {
  return pressure * (pressure / (2 * term.ratio * instantaneous_bulk_modulus) - volume_change);
}

}  // namespace pliant::kernels

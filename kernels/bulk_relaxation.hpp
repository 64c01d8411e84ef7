#pragma once

#include <cstdint>

#include "kernels/networks.hpp"

/// Relaxation of the bulk modulus, (RP.10), in the methods on the undeformed body.
namespace pliant::kernels {

/// The p_i at the stress points of a body; a body without Prony terms of the bulk modulus has none.
template <class T>
struct BulkRelaxation {
  int terms = 0;
  const Relaxation<T>* relaxation = nullptr;  ///< [term], since the last stress evaluation
  const T* const* pressure = nullptr;         ///< [term][slot] p_i at the last stress [Pa]
  T* const* next_pressure = nullptr;          ///< the same at this stress; may be the same arrays
  const T* volume_change = nullptr;           ///< [slot] J - 1 at the last stress
  T* next_volume_change = nullptr;            ///< the same at this stress; may be the same array
};

/// The sum of the p_i, advanced by (RP.22) to the change of volume J - 1 = `end`. `Slots` reads and
/// writes the values of a register of stress points.
template <class P, class Slots>
[[gnu::always_inline]] inline P relax_pressures(const BulkRelaxation<Scalar<P>>& bulk, const P& end,
                                                const Slots& slots) {
  P sum(Scalar<P>(0));
  if (bulk.terms == 0) return sum;
  const P start = slots.get(bulk.volume_change);
  for (int i = 0; i < bulk.terms; ++i) {
    const P before = slots.get(bulk.pressure[i]);
    const P after = relax_term(bulk.relaxation[i], before, start, end);
    slots.put(bulk.next_pressure[i], after, before);
    sum = sum + after;
  }
  slots.put(bulk.next_volume_change, end, start);
  return sum;
}

}  // namespace pliant::kernels

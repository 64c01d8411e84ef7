#pragma once

#include <cstdint>
#include <vector>

#include "engine/storage/buffer.hpp"
#include "kernels/material.hpp"

/// The relaxing part of the pressure, (RP.10), in plain numbers, for measurements and output. Steps
/// use the kernels.
namespace pliant {

/// Where the p_i of a body were at its last stress.
template <class T>
struct BulkHistory {
  const std::vector<kernels::PronyTerm<double>>& prony;
  const std::vector<Buffer<T>>& pressure;  ///< [term][stress point] p_i [Pa]
  const Buffer<T>& volume_change;          ///< [stress point] J - 1
  double modulus;                          ///< K0 [Pa]
  double age;                              ///< time since then [s]
};

struct RelaxedPressure {
  double pressure = 0;  ///< sum of the p_i [Pa]
  double energy = 0;    ///< of (RP.64), per undeformed volume [Pa]
};

/// The p_i at the stress point `slot`, advanced by (RP.22), now that its J - 1 is `volume_change`.
template <class T>
RelaxedPressure relaxed_pressure(const BulkHistory<T>& history, std::int64_t slot,
                                 double volume_change);

}  // namespace pliant

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "engine/method/registry.hpp"

/// What a run will cost, before it is set up.
namespace pliant {

/// Size and number of steps of a run.
struct Estimate {
  std::int64_t particles = 0, slots = 0, steps = 0;
  std::int64_t looks = 0;          ///< outputs that cost as much as a step each
  std::size_t bytes = 0;           ///< largest resident memory of `pliant run`, within a fifth
  bool nodes_are_counted = false;  ///< `particles` are nodes, as set-up has counted them

  /// One line for people.
  std::string text() const;
};

/// Counts particles and slots on the lattice of each body, on a coarser one where that has more
/// than a million cells, and steps with the wave speed at rest
/// and the strain rate at the start.
Estimate estimate(const Case& a_case);

/// Wall time of the steps of a run [s], within a factor of two: that of a few steps of the same
/// case, on a lattice of a few thousand particles where its own has more. None where such a lattice
/// does not hold the case.
std::optional<double> estimated_seconds(const Case& a_case, const Estimate& size,
                                        const SolverOptions& options,
                                        const MethodRegistry& methods);

/// Memory that this process may still take [bytes]: the least of what the machine has available,
/// what its control group leaves, and what its limit of address space leaves.
std::size_t available_memory();

/// Throws InputError where a run needs more than `available` bytes.
void refuse_what_does_not_fit(const Case& a_case, const Estimate& size, std::size_t available);

/// "850 MB", "1.2 GB".
std::string memory_text(std::size_t bytes);
/// "40 s", "12 min", "3.5 h", "2.1 days".
std::string duration_text(double seconds);

}  // namespace pliant

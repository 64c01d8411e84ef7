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
  std::int64_t looks = 0;  ///< outputs that each cost as much as a step
  std::size_t bytes = 0;   ///< peak resident memory of `pliant run`, to within a fifth
  bool nodes_are_counted =
      false;  ///< whether `particles` is the number of nodes that set-up has counted

  /// One line for users.
  std::string text() const;
};

/// Counts particles and slots on the lattice of each body, or on a coarser one if it has more than
/// a million cells. The number of steps follows from the wave speed at rest and the strain rate at
/// the start.
Estimate estimate(const Case& a_case);

/// Wall time of the steps of a run [s], within a factor of two. It is measured over a few steps of
/// the same case, on a coarser lattice if it has more than a few thousand particles. None if such a
/// lattice cannot hold the case.
std::optional<double> estimated_seconds(const Case& a_case, const Estimate& size,
                                        const SolverOptions& options,
                                        const MethodRegistry& methods);

/// Memory that this process may still allocate [B]: the smallest of what the machine has available
/// and what the limits of its control group and of its address space leave.
std::size_t available_memory();

/// Throws InputError if a run needs more than `available` bytes.
void refuse_what_does_not_fit(const Case& a_case, const Estimate& size, std::size_t available);

/// "850 MB", "1.2 GB".
std::string memory_text(std::size_t bytes);
/// "40 s", "12 min", "3.5 h", "2.1 days".
std::string duration_text(double seconds);

}  // namespace pliant

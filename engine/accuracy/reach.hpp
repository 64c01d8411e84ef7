#pragma once

#include <span>
#include <vector>

/// The cost of an error, from the runs of a ladder.
namespace pliant::accuracy {

/// Size, cost and error of one run.
struct Rated {
  double particles = 0, seconds = 0;
  double error = 0;  ///< relative; NaN for a run without a result
};

/// For each rung, the largest error of this and all finer rungs. A deviation that changes sign
/// between two spacings makes a single error small by chance, but this envelope never grows towards
/// finer rungs. Rungs without a result have no envelope and do not affect others.
std::vector<double> envelope(std::span<const Rated> rungs);

/// How well the runs of a ladder determine the cost of an error.
enum class Certainty {
  interpolated,  ///< between two rungs
  at_most,       ///< the coarsest rung already has a smaller error
  unconfirmed,   ///< only the finest rung has it, without confirmation
  not_reached
};

/// Particles and wall time [s] at which an error is reached.
struct Cost {
  Certainty certainty = Certainty::not_reached;
  double particles = 0, seconds = 0;
};

/// Particles and wall time at which the envelope reaches `error`, linear between two rungs in
/// logarithms of error and cost. `rungs` are in order, coarse first.
Cost cost_of(double error, std::span<const Rated> rungs);

}  // namespace pliant::accuracy

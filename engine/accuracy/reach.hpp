#pragma once

#include <span>
#include <vector>

/// What an error costs, from the runs of a ladder.
namespace pliant::accuracy {

/// Size, cost and error of one run.
struct Rated {
  double particles = 0, seconds = 0;
  double error = 0;  ///< relative; NaN where a run gave no answer
};

/// The largest error from each rung on to the finest one. A deviation that crosses zero between two
/// spacings makes a single error small by chance; this one never grows towards finer rungs. Rungs
/// without an answer stay so, and have no influence on others.
std::vector<double> envelope(std::span<const Rated> rungs);

/// How well the runs of a ladder determine the cost of an error.
enum class Certainty {
  interpolated,  ///< between two rungs
  at_most,       ///< the coarsest rung is that good already
  unconfirmed,   ///< only the finest rung is that good, and no finer one confirms it
  not_reached
};

/// Particles and wall time [s] at which an error is reached.
struct Cost {
  Certainty certainty = Certainty::not_reached;
  double particles = 0, seconds = 0;
};

/// Particles and wall time at which the envelope falls to `error`, between two rungs straight in
/// logarithms of error and cost. `rungs` are in order, coarse first.
Cost cost_of(double error, std::span<const Rated> rungs);

}  // namespace pliant::accuracy

#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/profile/profile.hpp"

/// The finest spacing with which a case holds a budget.
namespace pliant::profile {

/// One spacing that was tried.
struct FitTry {
  double spacing = 0;  ///< [m]
  std::int64_t particles = 0;
  double seconds = 0;  ///< frame time at the percentile; of the frames up to the stop
  bool held = false;
  std::string problem = {};  ///< why it could not run; empty where it could
};

/// All spacings that were tried, and the best of them.
struct Fit {
  std::vector<FitTry> tries;  ///< in order
  int best = -1;              ///< of `tries`; -1: no spacing holds the budget
};

/// Profiles the case with a spacing, or with one near it. A spacing with which it cannot run has a
/// `problem`; none ends the search.
using TrySpacing = std::function<std::optional<FitTry>(double spacing)>;

/// Searches from `spacing` [m] on until the finest spacing that holds the budget and the coarsest
/// that does not are within 3 %. The time of a frame falls with the power `dimension + 1` of the
/// spacing, or faster than the search could follow; at most 24 tries.
Fit fit_spacing(double spacing, double budget, int dimension, const TrySpacing& try_spacing);

/// The spacing nearest to `spacing` with which every period of the case is a whole number of cells
/// along the shortest periodic direction; `spacing` itself without one.
double fitting_spacing(const Case& settings, double spacing);

/// For people, and for programs.
std::string text_of(const Fit& fit, const ProfileOptions& options);
std::string json_of(const Fit& fit, const ProfileOptions& options);

}  // namespace pliant::profile

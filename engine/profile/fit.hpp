#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/profile/profile.hpp"

/// Finds the finest spacing with which a case meets a budget.
namespace pliant::profile {

/// One spacing that was tried.
struct FitTry {
  double spacing = 0;  ///< [m]
  std::int64_t particles = 0;
  double seconds = 0;  ///< frame time at the percentile, of the frames up to the stop
  bool held = false;
  std::string problem = {};  ///< why it could not run; empty if it could
};

/// All spacings that were tried, and the best of them.
struct Fit {
  std::vector<FitTry> tries;  ///< in order
  int best = -1;              ///< index in `tries`; -1: no spacing meets the budget
};

/// Profiles the case with a spacing, or with one close to it. If the case cannot run with it, the
/// result has a `problem`; no result ends the search.
using TrySpacing = std::function<std::optional<FitTry>(double spacing)>;

/// Searches from `spacing` [m] until the finest spacing that meets the budget and the coarsest one
/// that does not are within 3 %, in at most 24 tries. Assumes that the time of a frame falls with
/// the power `dimension + 1` of the spacing.
Fit fit_spacing(double spacing, double budget, int dimension, const TrySpacing& try_spacing);

/// The spacing nearest to `spacing` that divides the shortest period of the case into whole cells;
/// `spacing` itself without periods.
double fitting_spacing(const Case& settings, double spacing);

/// For users, and for programs.
std::string text_of(const Fit& fit, const ProfileOptions& options);
std::string json_of(const Fit& fit, const ProfileOptions& options);

}  // namespace pliant::profile

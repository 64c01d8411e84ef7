#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "engine/calibrate/parameter.hpp"

namespace pliant::calibrate {

/// Residuals (model minus data, over the standard deviation of the data) at each of several points,
/// which may be evaluated at the same time; none if the model has no values.
using Residuals = std::vector<double>;
using Evaluate = std::function<std::vector<std::optional<Residuals>>(
    const std::vector<std::vector<double>>& points)>;

enum class Determination { well, poorly, not_at_all };

/// The value of a parameter, and its error.
struct Estimated {
  double value = 0;
  double error = 0;  ///< standard error; infinite if undetermined
  /// Well: the standard error is below 5 %; not at all: above 50 %, or the value is at a bound.
  Determination determination = Determination::not_at_all;
};

struct Calibration {
  std::vector<Estimated> parameters;
  std::vector<std::vector<double>> correlation;
  Residuals residuals;
  int runs = 0;
  bool has_converged = false;  ///< otherwise the runs were used up
};

/// Limits of the search, and its finite differences.
struct OptimiserOptions {
  int most_runs = 60;
  double difference = 0.02;  ///< step of the finite differences [radian]
  double tolerance = 1e-3;   ///< relative change of the sum of squares at which the search ends
};

/// Least squares by Levenberg-Marquardt (Eigen's version of MINPACK), with finite differences whose
/// points are evaluated together. Standard errors and correlations are those of the linear model at
/// the result, with the variance of the residuals. Throws InputError if the model has no values at
/// the start or next to a point of the search.
Calibration optimise(const std::vector<Parameter>& parameters, const Evaluate& evaluate,
                     const OptimiserOptions& options);

}  // namespace pliant::calibrate

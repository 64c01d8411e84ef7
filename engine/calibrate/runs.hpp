#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "engine/batch/executor.hpp"
#include "engine/batch/ledger.hpp"
#include "engine/calibrate/fit.hpp"

namespace pliant::calibrate {

/// Thrown when a batch of a calibration was interrupted.
struct Interrupted {};

/// The history of a measurement at given times, linear between its samples; empty if it has no
/// value at one of them. Throws InputError if the run has no such measurement.
std::vector<double> history_at(const std::filesystem::path& result, const std::string& measurement,
                               const std::vector<double>& times);

/// Runs of the case of a fit: each set of points is a batch, DIR/round-1 and so on.
class Runs {
 public:
  Runs(const Fit& fit, const batch::BatchOptions& options) : fit_(fit), options_(options) {}

  /// Residuals of all curves, one after another; none for a run that failed. Throws Interrupted.
  std::vector<std::optional<Residuals>> operator()(const std::vector<std::vector<double>>& points);

 private:
  batch::Assignment assignment_of(const std::vector<double>& point) const;
  std::optional<Residuals> residuals_of(const std::filesystem::path& folder) const;

  const Fit& fit_;
  batch::BatchOptions options_;
  int round_ = 0;
};

}  // namespace pliant::calibrate

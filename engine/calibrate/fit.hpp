#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/calibrate/optimise.hpp"

namespace pliant::calibrate {

/// A measured curve that a measurement of the case should follow.
struct Curve {
  std::string measurement;
  std::vector<double> time, value;
  std::vector<double> deviation;  ///< standard deviation of each value: the inverse of its weight
};

/// What a fit file says.
struct Fit {
  std::string name;  ///< of the file
  std::filesystem::path case_file;
  std::vector<std::string> settings;  ///< key=value, of all runs
  std::vector<Parameter> parameters;
  std::vector<Curve> curves;
  double time_limit = 0;  ///< of a run [s]; 0: none
  OptimiserOptions optimiser;
};

/// Throws InputError, which names file, line and remedy.
Fit read_fit(const std::filesystem::path& file);

}  // namespace pliant::calibrate

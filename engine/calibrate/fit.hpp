#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/calibrate/optimise.hpp"

namespace pliant::calibrate {

/// A measured curve for a measurement of the case.
struct Curve {
  std::string measurement;
  std::vector<double> time, value;
  std::vector<double> deviation;  ///< standard deviation of each value, the inverse of its weight
};

struct Fit {
  std::string name;  ///< of the file
  std::filesystem::path case_file;
  std::vector<std::string> settings;  ///< key=value, of all runs
  std::vector<Parameter> parameters;
  std::vector<Curve> curves;
  double time_limit = 0;  ///< of a run [s]; 0: none
  OptimiserOptions optimiser;
};

/// Throws InputError that names file, line and remedy.
Fit read_fit(const std::filesystem::path& file);

}  // namespace pliant::calibrate

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/batch/designs.hpp"

namespace pliant::batch {

struct Sweep {
  std::string name;                   ///< of the file
  std::filesystem::path case_file;    ///< of the base case
  std::vector<std::string> settings;  ///< key=value, of all runs
  double time_limit = 0;              ///< of an attempt [s]; 0: none
  int retries = 0;                    ///< further attempts of a run that fails
  std::vector<Assignment> runs;       ///< with different names
  struct Slurm {
    std::vector<std::string> options;  ///< of sbatch
    int runs_per_task = 0;             ///< 0: by their estimated times
  } slurm;
};

/// Throws InputError that names file, line and remedy.
Sweep read_sweep(const std::filesystem::path& file);

}  // namespace pliant::batch

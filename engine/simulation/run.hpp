#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "engine/simulation/methods.hpp"

namespace pliant {

/// How to run a case: options that do not change its results.
struct RunOptions {
  std::filesystem::path folder;  ///< folder for the results
  int threads = 1;
  kernels::Isa isa = kernels::Isa::sse2;
  bool resume = false;
  bool quiet = false;
  std::function<void()> when_set_up = [] {};  ///< called once, before anything is written
};

enum class RunEnd { done, interrupted };

/// Runs a case from its start, or from the last checkpoint in the folder, to its end, or until
/// SIGINT, SIGTERM or SIGHUP, which leave a checkpoint. Writes result.h5, result.xdmf,
/// case.resolved.toml and summary.json. Throws OutputError and StepFailure, and InputError for a
/// folder whose checkpoint or result belongs to another run.
RunEnd run_case(const Case& settings, const RunOptions& options,
                const MethodRegistry& methods = pliant::methods());

}  // namespace pliant

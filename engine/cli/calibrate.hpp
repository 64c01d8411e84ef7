#pragma once

#include "engine/cli/batch.hpp"

namespace pliant::cli {

struct CalibrateArguments {
  std::filesystem::path fit;
  std::optional<std::filesystem::path> folder;  ///< default: results/<fit>
  int workers = 0, threads = 1;                 ///< as in BatchArguments
  bool resume = false, quiet = false, json = false;
};

/// Finds values of a case with which its measurements follow measured curves.
ExitStatus calibrate(const CalibrateArguments& arguments);

}  // namespace pliant::cli

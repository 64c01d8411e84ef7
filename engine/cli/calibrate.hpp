#pragma once

#include "engine/cli/batch.hpp"

namespace pliant::cli {

struct CalibrateArguments : RunsArguments {
  std::filesystem::path fit;
  bool json = false;
};

/// Finds values of a case for which its measurements follow measured curves.
ExitStatus calibrate(const CalibrateArguments& arguments);

}  // namespace pliant::cli

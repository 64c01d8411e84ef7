#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/cli/exit_status.hpp"

namespace pliant::cli {

struct ReportArguments {
  std::filesystem::path folder;               ///< of a run or a batch
  std::optional<std::filesystem::path> page;  ///< default: report.html in the folder
  std::vector<std::string> fields;
  std::optional<std::filesystem::path> reference;
};

/// Writes one file that shows a run or a batch in a browser.
ExitStatus report(const ReportArguments& arguments);

}  // namespace pliant::cli

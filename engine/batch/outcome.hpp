#pragma once

#include <filesystem>

#include "engine/batch/ledger.hpp"

namespace pliant::batch {

/// Adds the content of folder/summary.json to the outcome, so that the row of a run is complete
/// even if no process waited for it. False if the file, which a run writes last, does not exist.
bool read_summary(const std::filesystem::path& folder, Outcome& outcome);

/// The last non-empty line of a file.
std::string last_line(const std::filesystem::path& file);

}  // namespace pliant::batch

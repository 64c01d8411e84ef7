#pragma once

#include <filesystem>

#include "engine/batch/ledger.hpp"

namespace pliant::batch {

/// Puts what folder/summary.json says into the outcome, so that a run whose process nobody waited
/// for has a whole row; false where there is no such file, which runs write last.
bool read_summary(const std::filesystem::path& folder, Outcome& outcome);

/// The last line of a file that is not empty.
std::string last_line(const std::filesystem::path& file);

}  // namespace pliant::batch

#pragma once

#include <filesystem>

#include "engine/batch/ledger.hpp"

namespace pliant::batch {

/// Puts measurements and versions of folder/summary.json into the outcome; false where there is no
/// such file, which runs write last.
bool read_summary(const std::filesystem::path& folder, Outcome& outcome);

/// The last line of a file that is not empty.
std::string last_line(const std::filesystem::path& file);

}  // namespace pliant::batch

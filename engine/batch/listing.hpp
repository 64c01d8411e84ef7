#pragma once

#include <string>
#include <vector>

#include "engine/batch/ledger.hpp"

/// What a ledger holds, for people and for other programs.
namespace pliant::batch {

/// How many runs are done, running, pending and failed, and why those failed.
std::string status_text(const std::vector<RunRow>& rows);
std::string status_json(const std::vector<RunRow>& rows);

/// One line for each run: name, status, attempts, exit status, times, peak memory, parameters by
/// their keys, measurements by their names with units.
std::string csv_of(const std::vector<RunRow>& rows);

}  // namespace pliant::batch

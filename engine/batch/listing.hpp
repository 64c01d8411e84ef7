#pragma once

#include <string>
#include <vector>

#include "engine/batch/ledger.hpp"

/// The contents of a ledger, for users and for other programs.
namespace pliant::batch {

/// How many runs are done, running, pending and failed, and why they failed.
std::string status_text(const std::vector<RunRow>& rows);
std::string status_json(const std::vector<RunRow>& rows);

/// One line for each run: name, status, attempts, exit status, times, peak memory, parameters by
/// key, measurements by name with units.
std::string csv_of(const std::vector<RunRow>& rows);

}  // namespace pliant::batch

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/report/run_reader.hpp"

namespace pliant::report {

/// Curves over time from the columns of a CSV file whose first column is time; none if it is not.
/// Throws InputError for a file that does not contain numbers.
std::vector<History> read_references(const std::filesystem::path& file);

/// Whether a column belongs to a measurement: its name is that of the measurement, alone or before
/// `_`.
bool is_reference_of(const std::string& measurement, const std::string& column);

}  // namespace pliant::report

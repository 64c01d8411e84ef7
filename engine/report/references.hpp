#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/report/run_reader.hpp"

namespace pliant::report {

/// Curves over time in the columns of a CSV file, whose first column is time. None where it is
/// something else. Throws InputError for a file that cannot be read as numbers.
std::vector<History> read_references(const std::filesystem::path& file);

/// Whether a column belongs to a measurement: its name, alone or before `_`.
bool is_reference_of(const std::string& measurement, const std::string& column);

}  // namespace pliant::report

#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Tables as comma-separated values (RFC 4180).
namespace pliant::batch {

using CsvRow = std::vector<std::string>;

/// Empty lines are skipped. Throws std::invalid_argument for a quotation without an end.
std::vector<CsvRow> read_csv(std::string_view text);

/// One line with its line end, quoted where necessary.
std::string csv_line(const CsvRow& row);

}  // namespace pliant::batch

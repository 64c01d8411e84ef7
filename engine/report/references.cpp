#include "engine/report/references.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <charconv>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "engine/batch/csv.hpp"

namespace pliant::report {
namespace {

double number_of(const std::string& cell, const std::filesystem::path& file, std::size_t line) {
  if (cell.empty()) return std::numeric_limits<double>::quiet_NaN();
  double value = 0;
  const char* end = cell.data() + cell.size();
  const auto [rest, error] = std::from_chars(cell.data(), end, value);
  if (error == std::errc() && rest == end) return value;
  throw InputError(fmt::format("{}:{}: `{}` is no number; a reference has numbers below its names",
                               file.string(), line, cell));
}

std::vector<batch::CsvRow> rows_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(fmt::format("{}: cannot be read; give a CSV file", file.string()));
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  try {
    return batch::read_csv(text);
  } catch (const std::invalid_argument& error) {
    throw InputError(fmt::format("{}: {}; give a CSV file", file.string(), error.what()));
  }
}

}  // namespace

std::vector<History> read_references(const std::filesystem::path& file) {
  const auto rows = rows_of(file);
  if (rows.empty() || rows[0].empty() || (rows[0][0] != "t" && rows[0][0] != "time")) return {};
  std::vector<History> curves(rows[0].size() - 1);
  for (std::size_t c = 0; c < curves.size(); ++c) curves[c].name = rows[0][c + 1];
  for (std::size_t r = 1; r < rows.size(); ++r) {
    if (rows[r].size() != rows[0].size())
      throw InputError(fmt::format("{}:{}: {} cells where the first line has {}; complete it",
                                   file.string(), r + 1, rows[r].size(), rows[0].size()));
    const double time = number_of(rows[r][0], file, r + 1);
    for (std::size_t c = 0; c < curves.size(); ++c) {
      curves[c].time.push_back(time);
      curves[c].value.push_back(number_of(rows[r][c + 1], file, r + 1));
    }
  }
  return curves;
}

bool is_reference_of(const std::string& measurement, const std::string& column) {
  return column == measurement || column.starts_with(measurement + "_");
}

}  // namespace pliant::report

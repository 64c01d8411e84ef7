#include <fmt/format.h>
#include <toml++/toml.h>
#include <pliant/error.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "engine/batch/csv.hpp"
#include "engine/batch/read_design.hpp"
#include "engine/calibrate/fit.hpp"
#include "engine/case/reading/read_case.hpp"

namespace pliant::calibrate {

namespace {

using batch::refuse;
using batch::refuse_other_keys;
using batch::value_of;

Parameter parameter_of(const toml::table& table) {
  refuse_other_keys(table, {"key", "start", "lower", "upper", "scale"});
  const auto number = [&](std::string_view key) {
    return value_of(table, key, std::nan(""), "a number");
  };
  const auto scale = value_of<std::string>(table, "scale", "linear", "\"linear\" or \"log\"");
  Parameter parameter{value_of<std::string>(table, "key", "", "a key of the case"), number("start"),
                      number("lower"), number("upper"), scale == "log"};
  if (parameter.key.empty()) refuse(table, "a parameter has no `key`", "name a key of the case");
  const bool in_order = parameter.lower < parameter.start && parameter.start < parameter.upper;
  if (!in_order || !std::isfinite(parameter.upper - parameter.lower)) {
    refuse(table, fmt::format("the bounds of `{}` do not enclose its start", parameter.key),
           "give lower < start < upper");
  }
  if (scale != "linear" && !(scale == "log" && parameter.lower > 0)) {
    refuse(table, fmt::format("scale = \"{}\" does not suit `{}`", scale, parameter.key),
           "give \"linear\", or \"log\" with a positive lower bound");
  }
  return parameter;
}

double number_of(const std::string& text, const std::filesystem::path& file, std::size_t row) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error == std::errc() && rest == end && std::isfinite(value)) return value;
  throw InputError(
      fmt::format("{}: `{}` in row {} is no number; give numbers below one row of names",
                  file.string(), text, row));
}

/// Reads the first two columns of a CSV file with one row of names.
void read_columns(Curve& curve, const std::filesystem::path& file) {
  std::ifstream stream(file);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  std::vector<batch::CsvRow> rows;
  try {
    rows = batch::read_csv(text);
  } catch (const std::invalid_argument& error) {
    throw InputError(fmt::format("{}: {}; correct the CSV", file.string(), error.what()));
  }
  for (std::size_t row = 1; row < rows.size(); ++row) {
    if (rows[row].size() < 2) {
      throw InputError(fmt::format("{}: row {} has fewer than two columns; give time and value",
                                   file.string(), row + 1));
    }
    curve.time.push_back(number_of(rows[row][0], file, row + 1));
    curve.value.push_back(number_of(rows[row][1], file, row + 1));
  }
  if (curve.time.empty()) {
    throw InputError(
        fmt::format("{}: has no rows; give a row of names, then time and value", file.string()));
  }
}

Curve curve_of(const toml::table& table, const std::filesystem::path& folder) {
  refuse_other_keys(table, {"measurement", "file", "error", "relative_error"});
  Curve curve;
  curve.measurement = value_of<std::string>(table, "measurement", "", "a measurement of the case");
  const auto file = value_of<std::string>(table, "file", "", "the path of a CSV file");
  if (curve.measurement.empty() || file.empty()) {
    refuse(table, "a curve lacks `measurement` or `file`", "give both");
  }
  const double error = value_of(table, "error", 0.0, "a number");
  const double relative = value_of(table, "relative_error", 0.0, "a number");
  read_columns(curve, folder / file);
  for (const double value : curve.value) {
    curve.deviation.push_back(std::hypot(error, relative * value));
  }
  if (error < 0 || relative < 0 || std::ranges::min(curve.deviation) <= 0) {
    refuse(table, "a value of the curve has no positive error",
           "give error (in the unit of the measurement), or relative_error where no value is 0");
  }
  return curve;
}

/// Reads the tables of an array that must not be empty.
template <class Read>
void read_tables(const toml::table& root, std::string_view key, const Read& read) {
  const toml::array* tables = root[key].as_array();
  if (tables == nullptr || !tables->is_array_of_tables()) {
    refuse(root, fmt::format("there is no {}", key), fmt::format("write [[{}]]", key));
  }
  for (const toml::node& table : *tables) read(*table.as_table());
}

}  // namespace

Fit read_fit(const std::filesystem::path& file) {
  const toml::table root = batch::read_toml(file, "a fit file");
  refuse_other_keys(root, {"case", "set", "time_limit", "most_runs", "parameter", "curve"});
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  Fit fit;
  fit.name = file.stem().string();
  const auto base = value_of<std::string>(root, "case", "", "the path of a case");
  if (base.empty()) refuse(root, "there is no case", "write case = \"PATH\"");
  fit.case_file = case_path(folder / base).lexically_normal();
  if (const toml::array* settings = root["set"].as_array()) {
    for (const toml::node& setting : *settings) {
      const auto text = setting.value<std::string>();
      if (!text) refuse(setting, "a setting is no text", "write set = [\"time.end=0.1\"]");
      fit.settings.push_back(*text);
    }
  }
  fit.time_limit = value_of(root, "time_limit", 0.0, "a number of seconds");
  read_tables(root, "parameter",
              [&](const toml::table& table) { fit.parameters.push_back(parameter_of(table)); });
  read_tables(root, "curve",
              [&](const toml::table& table) { fit.curves.push_back(curve_of(table, folder)); });
  const auto most = value_of<std::int64_t>(root, "most_runs", 60, "a whole number");
  const auto least = static_cast<std::int64_t>(2 * fit.parameters.size() + 2);
  if (most < least || most > 100'000) {
    refuse(root, fmt::format("most_runs = {}", most),
           fmt::format("give at least {}: two rounds of differences", least));
  }
  fit.optimiser.most_runs = static_cast<int>(most);
  return fit;
}

}  // namespace pliant::calibrate

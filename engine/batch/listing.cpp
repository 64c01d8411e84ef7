#include "engine/batch/listing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/batch/csv.hpp"

namespace pliant::batch {

namespace {

std::array<int, 4> counts_of(const std::vector<RunRow>& rows) {
  std::array<int, 4> counts = {};
  for (const RunRow& row : rows) ++counts[static_cast<std::size_t>(row.status)];
  return counts;
}

std::string parameter_text(const Assignment& parameters) {
  std::string text;
  for (const auto& [key, value] : parameters) text += fmt::format(" {}={}", key, value);
  return text;
}

void add_new(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

std::string number_cell(double value) { return std::isnan(value) ? "" : number_text(value); }

std::string parameter_of(const RunRow& row, const std::string& key) {
  for (const auto& [name, value] : row.parameters) {
    if (name == key) return value;
  }
  return "";
}

std::string measurement_of(const RunRow& row, const std::string& name) {
  for (const auto& one : row.outcome.measurements) {
    if (one.name == name) return number_cell(one.value);
  }
  return "";
}

}  // namespace

std::string status_text(const std::vector<RunRow>& rows) {
  const auto counts = counts_of(rows);
  std::string text = fmt::format("{} runs:", rows.size());
  for (const RunStatus status :
       {RunStatus::done, RunStatus::running, RunStatus::pending, RunStatus::failed}) {
    text += fmt::format("{} {} {}", status == RunStatus::done ? "" : ",",
                        counts[static_cast<std::size_t>(status)], word_of(status));
  }
  text += "\n";
  for (const RunRow& row : rows) {
    if (row.status != RunStatus::failed) continue;
    text +=
        fmt::format("{}{}: {}\n", row.name, parameter_text(row.parameters), row.outcome.message);
  }
  return text;
}

std::string status_json(const std::vector<RunRow>& rows) {
  using Json = nlohmann::ordered_json;
  Json runs = Json::array();
  for (const RunRow& row : rows) {
    const Outcome& outcome = row.outcome;
    Json parameters = Json::object(), measurements = Json::object(), versions = Json::object();
    for (const auto& [key, value] : row.parameters) parameters[key] = value;
    for (const auto& one : outcome.measurements) {
      measurements[one.name] = {{"value", one.value}, {"unit", one.unit}};
    }
    for (const auto& [name, version] : outcome.versions) versions[name] = version;
    runs.push_back({{"name", row.name},
                    {"status", word_of(row.status)},
                    {"attempts", row.attempts},
                    {"exit_status", outcome.exit_status ? Json(*outcome.exit_status) : Json()},
                    {"message", outcome.message},
                    {"started", row.started},
                    {"ended", row.ended},
                    {"wall_seconds", outcome.wall_seconds},
                    {"processor_seconds", outcome.processor_seconds},
                    {"peak_memory", outcome.peak_memory},
                    {"parameters", parameters},
                    {"measurements", measurements},
                    {"versions", versions}});
  }
  return runs.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string csv_of(const std::vector<RunRow>& rows) {
  std::vector<std::string> keys, names;
  CsvRow heading = {"name",
                    "status",
                    "attempts",
                    "exit_status",
                    "wall_seconds",
                    "processor_seconds",
                    "peak_memory_bytes"};
  std::vector<std::string> columns;
  for (const RunRow& row : rows) {
    for (const auto& [key, value] : row.parameters) add_new(keys, key);
    for (const auto& one : row.outcome.measurements) {
      const std::string column = one.unit.empty() || one.unit == "1"
                                     ? one.name
                                     : fmt::format("{} [{}]", one.name, one.unit);
      if (std::find(names.begin(), names.end(), one.name) != names.end()) continue;
      names.push_back(one.name);
      columns.push_back(column);
    }
  }
  heading.insert(heading.end(), keys.begin(), keys.end());
  heading.insert(heading.end(), columns.begin(), columns.end());
  std::string text = csv_line(heading);
  for (const RunRow& row : rows) {
    const Outcome& outcome = row.outcome;
    const bool has_run = row.attempts > 0;
    CsvRow cells = {row.name,
                    std::string(word_of(row.status)),
                    fmt::format("{}", row.attempts),
                    outcome.exit_status ? fmt::format("{}", *outcome.exit_status) : "",
                    has_run ? number_cell(outcome.wall_seconds) : "",
                    has_run ? number_cell(outcome.processor_seconds) : "",
                    has_run ? fmt::format("{}", outcome.peak_memory) : ""};
    for (const std::string& key : keys) cells.push_back(parameter_of(row, key));
    for (const std::string& name : names) cells.push_back(measurement_of(row, name));
    text += csv_line(cells);
  }
  return text;
}

}  // namespace pliant::batch

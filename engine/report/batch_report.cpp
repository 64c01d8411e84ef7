#include "engine/report/batch_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/batch/ledger.hpp"
#include "engine/output/atomic_file.hpp"
#include "engine/report/page.hpp"

namespace pliant::report {
namespace {

using Json = nlohmann::ordered_json;

bool is_number(const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && rest == end && std::isfinite(value);
}

/// The parameters of all runs; those that are not numbers are ordered by their words.
Json parameters_of(const std::vector<batch::RunRow>& rows) {
  Json parameters = Json::array();
  std::vector<std::string> keys;
  for (const auto& row : rows) {
    for (const auto& [key, value] : row.parameters) {
      if (std::ranges::find(keys, key) == keys.end()) keys.push_back(key);
    }
  }
  for (const auto& key : keys) {
    std::vector<std::string> words;
    bool all_numbers = true;
    for (const auto& row : rows) {
      for (const auto& [name, value] : row.parameters) {
        if (name != key) continue;
        all_numbers = all_numbers && is_number(value);
        if (std::ranges::find(words, value) == words.end()) words.push_back(value);
      }
    }
    Json one = {{"key", key}, {"label", key}};
    if (!all_numbers) {
      std::string label = key;
      for (std::size_t i = 0; i < words.size(); ++i)
        label += fmt::format("{} {}: {}", i ? "," : "", i, words[i]);
      one["label"] = label;
      one["words"] = words;
    }
    parameters.push_back(one);
  }
  return parameters;
}

Json measurements_of(const std::vector<batch::RunRow>& rows) {
  Json measurements = Json::array();
  std::vector<std::string> names;
  for (const auto& row : rows) {
    for (const auto& one : row.outcome.measurements) {
      if (std::ranges::find(names, one.name) != names.end()) continue;
      names.push_back(one.name);
      measurements.push_back({{"name", one.name}, {"unit", one.unit}});
    }
  }
  return measurements;
}

Json json_of(const batch::RunRow& row) {
  Json parameters = Json::object(), measurements = Json::object();
  for (const auto& [key, value] : row.parameters) parameters[key] = value;
  for (const auto& one : row.outcome.measurements) measurements[one.name] = one.value;
  return {{"name", row.name},
          {"status", batch::word_of(row.status)},
          {"parameters", parameters},
          {"measurements", measurements}};
}

Json notes_of(const std::vector<batch::RunRow>& rows) {
  Json notes = Json::array();
  const auto unfinished = std::ranges::count_if(
      rows, [](const auto& row) { return row.status != batch::RunStatus::done; });
  if (unfinished > 0)
    notes.push_back(fmt::format("{} runs are not done and have no points.", unfinished));
  return notes;
}

}  // namespace

void write_batch_report(const std::filesystem::path& folder, const std::filesystem::path& page) {
  const auto rows = batch::Ledger(folder, batch::Ledger::Use::read).rows();
  Json runs = Json::array();
  for (const auto& row : rows) runs.push_back(json_of(row));
  const std::string title = fmt::format("Batch {}", folder.lexically_normal().filename().string());
  const Json json = {{"kind", "batch"},
                     {"title", title},
                     {"notes", notes_of(rows)},
                     {"parameters", parameters_of(rows)},
                     {"measurements", measurements_of(rows)},
                     {"runs", runs}};
  const auto text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  write_atomically(page, page_of(title, text, {}), Durable::no);
}

}  // namespace pliant::report

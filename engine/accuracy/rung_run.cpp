#include "engine/accuracy/rung_run.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/batch/outcome.hpp"
#include "engine/output/atomic_file.hpp"

namespace pliant::accuracy {

namespace {

using Json = nlohmann::ordered_json;

std::filesystem::path kept_file(const RungRun& run) {
  std::filesystem::path file = run.folder;
  file += ".json";
  return file;
}

double measured_value(const batch::Outcome& outcome, const std::string& measurement) {
  for (const auto& one : outcome.measurements) {
    if (one.name == measurement) return one.value;
  }
  throw InputError(
      fmt::format("the case does not measure `{}`, which is a target; take one of its "
                  "measurements, or add it with `set`",
                  measurement));
}

/// The command without the path of the program, which may change.
std::vector<std::string> arguments_of(const RungRun& run) {
  return {run.command.begin() + 1, run.command.end()};
}

}  // namespace

void keep(const RungRun& run, const batch::Outcome& outcome) {
  const Json json = {{"command", arguments_of(run)},
                     {"wall_seconds", outcome.wall_seconds},
                     {"processor_seconds", outcome.processor_seconds},
                     {"peak_memory", outcome.peak_memory}};
  write_atomically(kept_file(run), json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n",
                   Durable::no);
}

std::optional<batch::Outcome> kept(const RungRun& run) {
  std::ifstream file(kept_file(run));
  const Json json = Json::parse(file, nullptr, false);
  if (!json.is_object() || json.value("command", Json()) != Json(arguments_of(run))) {
    return std::nullopt;
  }
  batch::Outcome outcome;
  outcome.exit_status = 0;
  if (!batch::read_summary(run.folder, outcome)) return std::nullopt;
  outcome.wall_seconds = json.value("wall_seconds", std::nan(""));
  outcome.processor_seconds = json.value("processor_seconds", std::nan(""));
  outcome.peak_memory = json.value("peak_memory", std::int64_t{0});
  return outcome;
}

void add(RungRecord& record, const batch::Outcome& outcome, const std::vector<Target>& targets) {
  if (outcome.exit_status != 0) {
    record.error = std::nan("");
    record.message = outcome.message;
    return;
  }
  record.seconds.push_back(outcome.wall_seconds);
  record.processor_seconds.push_back(outcome.processor_seconds);
  record.particles = outcome.particles;
  record.steps = outcome.steps;
  record.peak_memory = std::max(record.peak_memory, outcome.peak_memory);
  record.values.clear();
  record.error = 0;
  for (const Target& target : targets) {
    const double value = measured_value(outcome, target.measurement);
    record.values.emplace_back(target.measurement, value);
    const double error = std::abs(value - target.reference) / target.scale;
    if (std::isnan(error)) {
      record.error = std::nan("");
      record.message = fmt::format("{} has no value", target.measurement);
      return;
    }
    record.error = std::max(record.error, error);
  }
}

}  // namespace pliant::accuracy

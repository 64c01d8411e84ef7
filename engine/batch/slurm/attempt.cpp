#include "engine/batch/slurm/attempt.hpp"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/batch/outcome.hpp"
#include "engine/output/atomic_file.hpp"

namespace pliant::batch::slurm {

namespace {

using Json = nlohmann::ordered_json;

std::filesystem::path file_of(std::filesystem::path folder) {
  folder += ".attempt.json";
  return folder;
}

double number_of(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_number() ? found->get<double>() : std::nan("");
}

}  // namespace

void write_attempt(const std::filesystem::path& folder, const Attempt& attempt) {
  const RunRow& row = attempt.row;
  Json json = {{"status", word_of(row.status)},
               {"attempts", row.attempts},
               {"attempts_left", attempt.attempts_left},
               {"started", row.started},
               {"ended", row.ended},
               {"message", row.outcome.message},
               {"wall_seconds", row.outcome.wall_seconds},
               {"processor_seconds", row.outcome.processor_seconds},
               {"peak_memory", row.outcome.peak_memory}};
  if (row.outcome.exit_status) json["exit_status"] = *row.outcome.exit_status;
  // Messages of programs may not be UTF-8, but JSON must be.
  write_atomically(file_of(folder), json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n",
                   Durable::no);
}

std::optional<Attempt> read_attempt(const std::filesystem::path& folder) {
  std::ifstream file(file_of(folder));
  if (!file) return std::nullopt;
  const Json json = Json::parse(file, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  Attempt attempt;
  attempt.attempts_left = json.value("attempts_left", 1);
  RunRow& row = attempt.row;
  row.name = folder.filename().string();
  row.status = status_of(json.value("status", ""));
  row.attempts = json.value("attempts", std::int64_t{0});
  row.started = number_of(json, "started");
  row.ended = number_of(json, "ended");
  if (row.status == RunStatus::done) read_summary(folder, row.outcome);
  if (json.contains("exit_status")) row.outcome.exit_status = json["exit_status"];
  row.outcome.message = json.value("message", "");
  row.outcome.wall_seconds = json.value("wall_seconds", 0.0);
  row.outcome.processor_seconds = json.value("processor_seconds", 0.0);
  row.outcome.peak_memory = json.value("peak_memory", std::int64_t{0});
  return attempt;
}

}  // namespace pliant::batch::slurm

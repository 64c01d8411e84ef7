#include "engine/batch/outcome.hpp"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

namespace pliant::batch {

bool read_summary(const std::filesystem::path& folder, Outcome& outcome) {
  std::ifstream file(folder / "summary.json");
  const auto summary = nlohmann::ordered_json::parse(file, nullptr, false);
  if (summary.is_discarded()) return false;
  outcome.wall_seconds = summary.value("wall_time", 0.0);
  outcome.processor_seconds = summary.value("processor_time", 0.0);
  outcome.peak_memory = summary.value("peak_memory", std::int64_t{0});
  using Pointer = nlohmann::ordered_json::json_pointer;
  outcome.particles = summary.value(Pointer("/particles/start"), std::int64_t{0});
  outcome.steps = summary.value("steps", std::int64_t{0});
  for (const auto& [name, measurement] : summary["measurements"].items()) {
    const auto& value = measurement["value"];
    outcome.measurements.push_back({name, measurement["unit"].get<std::string>(),
                                    value.is_number() ? value.get<double>() : std::nan("")});
  }
  for (const auto& [name, version] : summary["versions"].items()) {
    outcome.versions.emplace_back(name, version.get<std::string>());
  }
  return true;
}

std::string last_line(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string last;
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty()) last = line;
  }
  return last;
}

}  // namespace pliant::batch

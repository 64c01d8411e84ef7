#include "engine/accuracy/record.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace pliant::accuracy {

namespace {

using Json = nlohmann::ordered_json;

const char* word_of(Certainty certainty) {
  switch (certainty) {
    case Certainty::interpolated:
      return "interpolated";
    case Certainty::at_most:
      return "at_most";
    case Certainty::unconfirmed:
      return "unconfirmed";
    case Certainty::not_reached:
      break;
  }
  return "not_reached";
}

Json json_of(const RungRecord& rung) {
  Json values = Json::object();
  for (const auto& [name, value] : rung.values) values[name] = value;
  return {{"settings", rung.settings},
          {"particles", rung.particles},
          {"steps", rung.steps},
          {"seconds", rung.seconds},
          {"processor_seconds", rung.processor_seconds},
          {"error", rung.error},
          {"peak_memory", rung.peak_memory},
          {"values", std::move(values)},
          {"message", rung.message}};
}

Json json_of(const SeriesRecord& row) {
  Json rungs = Json::array(), costs = Json::array();
  for (const RungRecord& rung : row.rungs) rungs.push_back(json_of(rung));
  for (const double error : errors_of_interest) {
    const Cost cost = row.cost_of(error);
    Json entry = {{"error", error}, {"certainty", word_of(cost.certainty)}};
    if (cost.certainty != Certainty::not_reached) {
      entry["seconds"] = cost.seconds;
      entry["particles"] = cost.particles;
    }
    costs.push_back(std::move(entry));
  }
  return {{"problem", row.problem}, {"series", row.series}, {"rungs", rungs}, {"costs", costs}};
}

}  // namespace

double RungRecord::median_seconds() const {
  if (seconds.empty()) return std::nan("");
  std::vector<double> sorted = seconds;
  std::sort(sorted.begin(), sorted.end());
  const std::size_t half = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[half] : 0.5 * (sorted[half - 1] + sorted[half]);
}

Cost SeriesRecord::cost_of(double error) const {
  std::vector<Rated> rated;
  for (const RungRecord& rung : rungs) {
    rated.push_back({static_cast<double>(rung.particles), rung.median_seconds(), rung.error});
  }
  return accuracy::cost_of(error, rated);
}

std::string json_of(const AccuracyRecord& record) {
  Json rows = Json::array();
  for (const SeriesRecord& row : record.rows) rows.push_back(json_of(row));
  const Json json = {{"format", "pliant accuracy 1"},
                     {"machine", record.machine},
                     {"threads", record.threads},
                     {"rows", rows}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace pliant::accuracy

#include <nlohmann/json.hpp>
#include <pliant/version.hpp>

#include "engine/case/vocabulary/words.hpp"
#include "engine/profile/report.hpp"
#include "kernels/isa.hpp"

namespace pliant::profile {

namespace {

using Json = nlohmann::ordered_json;

Json json(const Distribution& times) {
  return {{"mean", times.mean}, {"p50", times.p50},    {"p95", times.p95},
          {"p99", times.p99},   {"p99.9", times.p999}, {"max", times.most}};
}

Json json(const FrameRecord& frame, std::size_t index, const std::vector<std::string>& names) {
  Json parts = Json::object();
  const std::vector<double> seconds = parts_of(frame);
  for (std::size_t i = 0; i < names.size(); ++i) parts[names[i]] = seconds[i];
  return {{"frame", index},
          {"simulated_time", frame.simulated_time},
          {"seconds", frame.wall_seconds},
          {"steps", frame.steps},
          {"remeshings", frame.remeshings},
          {"load", frame.load},
          {"processor_seconds", frame.machine.processor_seconds},
          {"involuntary_context_switches", frame.machine.involuntary_switches},
          {"stolen_seconds", frame.machine.stolen_seconds},
          {"parts", parts}};
}

Json json(const std::vector<Part>& parts) {
  Json table = Json::object();
  for (const Part& part : parts) {
    table[part.name] = {{"share", part.share},
                        {"median", part.median},
                        {"in_worst", part.in_worst},
                        {"excess", part.excess()}};
  }
  return table;
}

template <class Record, class Value>
Json column(const std::vector<Record>& records, Value Record::*value) {
  Json values = Json::array();
  for (const Record& record : records) values.push_back(record.*value);
  return values;
}

}  // namespace

std::string json_of(const Profile& profile, const Verdict& verdict) {
  const Case& settings = profile.settings;
  const ProfileOptions& options = profile.options;
  const auto names = names_of_parts(profile.phases);
  Json worst = Json::array();
  for (const std::size_t index : verdict.worst) {
    worst.push_back(json(profile.frames[index], index, names));
  }
  const Json report = {{"pliant", version},
                       {"case", settings.name},
                       {"method", settings.method},
                       {"precision", words<Precision>[static_cast<int>(settings.precision)].text},
                       {"spacing", settings.discretisation.spacing},
                       {"particles", profile.particles},
                       {"machine", profile.machine},
                       {"threads", options.machine.threads},
                       {"isa", kernels::name(options.machine.isa)},
                       {"load_before", profile.load_before},
                       {"load_after", profile.frames.back().load},
                       {"interrupted", profile.interrupted},
                       {"frame_time", options.frame_seconds},
                       {"warm_up_frames", profile.warm_up},
                       {"budget", options.budget},
                       {"percentile", options.percentile},
                       {"held", verdict.held},
                       {"seconds_at_percentile", verdict.at_percentile},
                       {"missed", verdict.missed},
                       {"longest_streak", verdict.longest_streak},
                       {"real_time_factor", verdict.real_time_factor},
                       {"frame_seconds", json(verdict.frames)},
                       {"step_seconds", json(verdict.steps)},
                       {"parts", json(verdict.parts)},
                       {"to_blame", verdict.parts[verdict.to_blame].name},
                       {"measuring_share", profile.own_share},
                       {"worst", worst},
                       {"frames",
                        {{"simulated_time", column(profile.frames, &FrameRecord::simulated_time)},
                         {"seconds", column(profile.frames, &FrameRecord::wall_seconds)},
                         {"load", column(profile.frames, &FrameRecord::load)}}},
                       {"steps",
                        {{"simulated_time", column(profile.steps, &StepTime::simulated_time)},
                         {"seconds", column(profile.steps, &StepTime::wall_seconds)}}}};
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace pliant::profile

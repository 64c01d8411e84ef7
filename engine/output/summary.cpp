#include "engine/output/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/output/atomic_file.hpp"

namespace pliant {
namespace {

using Json = nlohmann::ordered_json;

Json json(const ConservedQuantities& quantities) {
  return {{"mass", quantities.mass},
          {"momentum", quantities.momentum},
          {"angular_momentum", quantities.angular_momentum},
          {"kinetic_energy", quantities.kinetic_energy},
          {"strain_energy", quantities.strain_energy},
          {"total_energy", quantities.total_energy}};
}

Json json(const SummaryChecks::Largest& largest) {
  return {{"largest_share", largest.share}, {"time", largest.time}};
}

Json json(const SummaryChecks& checks) {
  Json energy = nullptr;
  if (checks.energy_is_known) {
    energy = {{"work_of_walls", checks.wall_work},
              {"work_of_loads", checks.load_work},
              {"work_of_gravity", checks.body_force_work},
              {"work_of_cuts", checks.cut_work},
              {"work_of_blades", checks.blade_work},
              {"lost_by_damping", checks.damping},
              {"lost_by_friction", checks.friction},
              {"created", checks.created},
              {"largest_energy_or_work", checks.largest_energy},
              {"largest_share", checks.energy.share},
              {"time", checks.energy.time}};
  }
  return {{"energy", energy},
          {"mass", json(checks.mass)},
          {"momentum", json(checks.momentum)},
          {"angular_momentum", json(checks.angular_momentum)}};
}

Json json(const Summary& summary) {
  auto versions = Json::object(), phases = Json::object(), measurements = Json::object();
  for (const auto& [name, version] : summary.versions) versions[name] = version;
  for (const auto& phase : summary.phases) phases[phase.name] = phase.wall_time;
  for (const auto& measurement : summary.measurements) {
    Json& entry = measurements[measurement.name];
    entry = {{"value", measurement.value}, {"unit", measurement.unit}};
    if (!measurement.reason.empty()) entry["reason"] = measurement.reason;
  }
  const auto& speed = summary.performance;
  return {{"case", summary.case_name},
          {"versions", versions},
          {"method", summary.method},
          {"precision", summary.precision},
          {"particles",
           {{"start", summary.particles.start},
            {"end", summary.particles.end},
            {"ghosts", summary.particles.ghosts}}},
          {"steps", summary.steps},
          {"physical_time", summary.physical_time},
          {"wall_time", summary.wall_time},
          {"processor_time", summary.processor_time},
          {"peak_memory", summary.peak_memory},
          {"phases", phases},
          {"performance",
           {{"particle_stages_per_second", speed.particle_stages_per_second},
            {"particle_stages", speed.particle_stages},
            {"step_wall_time", speed.step_wall_time},
            {"threads", speed.threads},
            {"isa", speed.isa}}},
          {"conserved",
           {{"start", json(summary.conserved.start)}, {"end", json(summary.conserved.end)}}},
          {"checks", json(summary.checks)},
          {"measurements", measurements}};
}

}  // namespace

std::string json_of(const Summary& summary) {
  // Names may come from folders, whose names may not be UTF-8.
  constexpr auto errors = Json::error_handler_t::replace;
  return json(summary).dump(2, ' ', false, errors) + "\n";
}

namespace {

std::string checks_of(const SummaryChecks& checks) {
  const std::string mass = fmt::format("by at most {:.2g} %\n", 100 * checks.mass.share);
  if (!checks.energy_is_known) return "checks: mass changed " + mass;
  const double energy =
      checks.largest_energy > 0 ? 100 * checks.created / checks.largest_energy : 0;
  return fmt::format(
      "checks: energy changed by {:+.2g} % without work (gained at most {:.2g} %), mass {}", energy,
      100 * checks.energy.share, mass);
}

}  // namespace

std::string report_of(const std::filesystem::path& folder, const Summary& summary) {
  std::string text = fmt::format(
      "results in {0}; `pliant report {0}` shows them in a browser, result.xdmf in ParaView\n",
      folder.string());
  std::size_t width = 0;
  for (const auto& measurement : summary.measurements)
    width = std::max(width, measurement.name.size());
  for (const auto& [name, unit, value, reason] : summary.measurements)
    text += std::isfinite(value) ? fmt::format("  {:<{}}  {:.6g}{}\n", name, width, value,
                                               unit == "1" ? "" : " " + unit)
                                 : fmt::format("  {:<{}}  no value: {}\n", name, width, reason);
  return text + checks_of(summary.checks);
}

void write_summary(const std::filesystem::path& folder, const Summary& summary) {
  write_atomically(folder / "summary.json", json_of(summary), Durable::yes);
}

}  // namespace pliant

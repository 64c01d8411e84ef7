#include <fmt/format.h>
#include <pliant/error.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>

#include "engine/case/method_rules.hpp"
#include "engine/case/writing/validate_summary.hpp"
#include "engine/cli/actions.hpp"
#include "engine/output/colour.hpp"
#include "engine/simulation/estimate.hpp"
#include "engine/simulation/examine.hpp"
#include "engine/simulation/methods.hpp"
#include "engine/simulation/solver_options.hpp"

namespace pliant::cli {

namespace {

using Json = nlohmann::ordered_json;

/// What a case would run, and its cost.
struct Checked {
  Case settings;
  Estimate size;
  std::optional<Examined> nodes;  ///< for methods with nodes
  SolverOptions machine;
  std::optional<double> seconds;  ///< none if no small lattice can hold the case
  std::vector<std::string> warnings;
};

Json json_of(const ExaminedBody& body) {
  return {{"name", body.name},
          {"nodes", body.nodes},
          {"volume", body.volume},
          {"volume_error", body.volume_error()},
          {"worst_condition", body.condition},
          {"worst_place", body.worst},
          {"degenerate_nodes", body.degenerate}};
}

Json json_of(const ExaminedContact& contact) {
  return {{"names", contact.names},
          {"corners", contact.corners},
          {"facets", contact.facets},
          {"penetration", contact.penetration},
          {"deepest", contact.deepest}};
}

template <class Examined>
Json list_of(const std::vector<Examined>& items) {
  Json list = Json::array();
  for (const Examined& item : items) list.push_back(json_of(item));
  return list;
}

/// Replaces estimates by the numbers of nodes and steps.
void count_nodes(const Examined& nodes, double end, Estimate& size) {
  size.steps = std::llround(std::ceil(end / nodes.time_step));
  size.nodes_are_counted = true;
  size.particles = 0;
  for (const ExaminedBody& body : nodes.bodies) size.particles += body.nodes;
}

Json json_of(const Checked& checked) {
  const Case& settings = checked.settings;
  Json measurements = Json::array();
  for (const MeasurementCase& m : settings.measurements) measurements.push_back(m.name);
  return {{"name", settings.name},
          {"title", settings.title},
          {"method", settings.method},
          {"dimension", settings.dimension},
          {"spacing", settings.discretisation.spacing},
          {"end", settings.time.end},
          {"particles", checked.size.particles},
          {"slots", checked.size.slots},
          {"steps", checked.size.steps},
          {"time_step", checked.nodes ? Json(checked.nodes->time_step) : Json()},
          {"stable_step", checked.nodes ? Json(checked.nodes->stable_step) : Json()},
          {"bodies", checked.nodes ? list_of(checked.nodes->bodies) : Json::array()},
          {"contacts", checked.nodes ? list_of(checked.nodes->contacts) : Json::array()},
          {"memory_bytes", checked.size.bytes},
          {"threads", checked.machine.threads},
          {"seconds", checked.seconds ? Json(*checked.seconds) : Json()},
          {"measurements", measurements},
          {"warnings", checked.warnings}};
}

std::vector<std::filesystem::path> case_files(const std::filesystem::path& folder) {
  std::error_code error;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    std::error_code unreadable;
    const auto file = entry.path() / "case.toml";
    if (std::filesystem::exists(file, unreadable)) files.push_back(file);
  }
  if (error) {
    throw InputError(fmt::format("{}: cannot be listed: {}; give a folder that holds cases",
                                 folder.string(), error.message()));
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// All warnings of a run before its first step.
std::vector<std::string> all_warnings(const Case& settings) {
  std::vector<std::string> warnings = warnings_of(settings);
  std::ranges::copy(warnings_of_method(settings), std::back_inserter(warnings));
  return warnings;
}

/// Names of files may not be UTF-8, but JSON must be.
std::string text_of(const Json& json) {
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

ExitStatus check(const CheckArguments& arguments) {
  Checked checked;
  checked.settings = read_case(arguments.source.path, arguments.source.settings);
  checked.warnings = all_warnings(checked.settings);
  checked.size = estimate(checked.settings);
  checked.nodes = examine(checked.settings);
  if (checked.nodes) {
    count_nodes(*checked.nodes, checked.settings.time.end, checked.size);
    const std::string unstable = checked.nodes->stability_warning();
    if (!unstable.empty()) checked.warnings.push_back(unstable);
  }
  checked.machine = solver_options(0, "");
  for (const std::string& warning : checked.warnings) {
    if (arguments.json) break;
    fmt::print(stderr, "{} {}\n", coloured("warning:", Colour::yellow, stderr), warning);
  }
  checked.seconds = estimated_seconds(checked.settings, checked.size, checked.machine, methods());
  if (arguments.json) {
    fmt::print("{}", text_of(json_of(checked)));
    return ExitStatus::done;
  }
  std::optional<double> step;
  if (checked.nodes) step = checked.nodes->time_step;
  fmt::print("{}  cost: {}", validate_summary(checked.settings, step), checked.size.text());
  if (checked.seconds) {
    fmt::print(", {} on {} threads (within a factor of two)", duration_text(*checked.seconds),
               checked.machine.threads);
  }
  fmt::print("\n");
  if (checked.nodes) {
    for (const ExaminedBody& body : checked.nodes->bodies) fmt::print("  {}\n", body.text());
    for (const ExaminedContact& contact : checked.nodes->contacts) {
      fmt::print("  {}\n", contact.text());
    }
    fmt::print("  {}\n", checked.nodes->step_text());
  }
  return ExitStatus::done;
}

ExitStatus list(const ListArguments& arguments) {
  Json rows = Json::array();
  for (const auto& file : case_files(arguments.folder)) {
    const Case settings = read_case(file);
    if (arguments.json) {
      rows.push_back({{"file", file.string()},
                      {"name", settings.name},
                      {"title", settings.title},
                      {"method", settings.method},
                      {"dimension", settings.dimension}});
    } else {
      fmt::print("{:40} {}\n", file.string(), settings.title);
    }
  }
  if (arguments.json) fmt::print("{}", text_of(rows));
  return ExitStatus::done;
}

}  // namespace pliant::cli

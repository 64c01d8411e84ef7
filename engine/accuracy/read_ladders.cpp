#include <pliant/error.hpp>

#include <cmath>

#include "engine/accuracy/ladders.hpp"
#include "engine/batch/read_design.hpp"
#include "engine/case/reading/read_case.hpp"

namespace pliant::accuracy {

namespace {

using batch::refuse;
using batch::refuse_other_keys;
using batch::value_of;

/// The tables of a list of tables; empty if the key does not exist.
std::vector<const toml::table*> tables_of(const toml::table& parent, std::string_view key,
                                          bool required) {
  std::vector<const toml::table*> tables;
  const toml::node* node = parent.get(key);
  if (node == nullptr && !required) return tables;
  const toml::array* list = node == nullptr ? nullptr : node->as_array();
  if (list == nullptr || list->empty() || !list->is_array_of_tables()) {
    refuse(node == nullptr ? static_cast<const toml::node&>(parent) : *node,
           fmt::format("there is no list of tables `{}`", key), fmt::format("write [[{}]]", key));
  }
  for (const toml::node& one : *list) tables.push_back(one.as_table());
  return tables;
}

std::string name_in(const toml::table& table) {
  auto name = value_of<std::string>(table, "name", "", "a name");
  if (name.empty()) refuse(table, "there is no `name`", "write name = \"compact\"");
  return name;
}

std::vector<Rung> rungs_of(const toml::table& table) {
  std::vector<Rung> rungs;
  const toml::node* node = table.get("rungs");
  if (node == nullptr) return rungs;
  const std::string example = R"(write rungs = ["discretisation.spacing=0.1", ...], coarse first)";
  const toml::array* list = node->as_array();
  if (list == nullptr || list->empty()) refuse(*node, "`rungs` is no list of settings", example);
  for (const toml::node& one : *list) {
    if (const auto text = one.value<std::string>()) {
      rungs.push_back({*text});
      continue;
    }
    const toml::array* settings = one.as_array();
    if (settings == nullptr) refuse(one, "a rung is neither a text nor a list of texts", example);
    Rung rung;
    for (const toml::node& setting : *settings) {
      const auto text = setting.value<std::string>();
      if (!text) refuse(setting, "a setting of a rung is no text", example);
      rung.push_back(*text);
    }
    rungs.push_back(rung);
  }
  return rungs;
}

int quick_rungs_of(const toml::table& table, int otherwise) {
  const auto count = value_of<std::int64_t>(table, "quick", otherwise, "a whole number");
  if (count < 0 || count > 1000) {
    refuse(table, "`quick` is out of range", "give the number of rungs that --quick takes");
  }
  return static_cast<int>(count);
}

Target target_of(const toml::table& table) {
  refuse_other_keys(table, {"measurement", "reference", "scale"});
  Target target;
  target.measurement =
      value_of<std::string>(table, "measurement", "", "the name of a measurement of the case");
  target.reference = value_of(table, "reference", std::nan(""), "a number");
  target.scale = value_of(table, "scale", std::abs(target.reference), "a number");
  if (target.measurement.empty() || !std::isfinite(target.reference)) {
    refuse(table, "a target has no `measurement` or no `reference`",
           "name a measurement of the case and give its right value");
  }
  if (!(target.scale > 0)) {
    refuse(table, "the scale of a target is not positive",
           "give `scale`, what deviations are divided by, where the reference is 0");
  }
  return target;
}

Series series_of(const toml::table& table, const Series& usual) {
  refuse_other_keys(table, {"name", "set", "rungs", "quick"});
  Series series;
  series.name = name_in(table);
  series.settings = batch::texts_of(table, "set", R"(set = ["discretisation.kernel=compact"])");
  series.rungs = rungs_of(table);
  if (series.rungs.empty()) series.rungs = usual.rungs;
  if (series.rungs.empty()) {
    refuse(table, fmt::format("`{}` has no rungs", series.name),
           R"(write rungs = ["discretisation.spacing=0.1", ...] here or for the problem)");
  }
  series.quick_rungs = quick_rungs_of(table, usual.quick_rungs);
  return series;
}

Problem problem_of(const toml::table& table, const std::filesystem::path& folder) {
  refuse_other_keys(table, {"name", "case", "set", "rungs", "quick", "target", "series"});
  Problem problem;
  problem.name = name_in(table);
  const auto file = value_of<std::string>(table, "case", "", "the path of a case");
  if (file.empty()) refuse(table, "there is no case", "write case = \"PATH\"");
  problem.case_file = case_path(folder / file).lexically_normal();
  problem.settings = batch::texts_of(table, "set", "set = [\"time.end=0.1\"]");
  for (const toml::table* target : tables_of(table, "target", true)) {
    problem.targets.push_back(target_of(*target));
  }
  const Series usual{"", {}, rungs_of(table), quick_rungs_of(table, 2)};
  for (const toml::table* series : tables_of(table, "series", true)) {
    problem.series.push_back(series_of(*series, usual));
  }
  return problem;
}

}  // namespace

Ladders read_ladders(const std::filesystem::path& file) {
  const toml::table root = batch::read_toml(file, "a file of ladders, as bench/accuracy.toml");
  refuse_other_keys(root, {"time_limit", "problem"});
  Ladders ladders;
  ladders.time_limit = value_of(root, "time_limit", 0.0, "a number of seconds");
  if (!(ladders.time_limit >= 0)) {
    refuse(root, "time_limit is negative", "give a number of seconds, or 0 for no limit");
  }
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  for (const toml::table* problem : tables_of(root, "problem", true)) {
    ladders.problems.push_back(problem_of(*problem, folder));
  }
  return ladders;
}

Ladders selected(const Ladders& ladders, const std::string& rows, bool quick) {
  Ladders few{ladders.time_limit, {}};
  for (Problem problem : ladders.problems) {
    std::erase_if(problem.series, [&](const Series& series) {
      const std::string name = problem.name + "/" + series.name;
      return name.find(rows) == std::string::npos || (quick && series.quick_rungs == 0);
    });
    for (Series& series : problem.series) {
      const auto count = static_cast<std::size_t>(series.quick_rungs);
      if (quick && series.rungs.size() > count) series.rungs.resize(count);
    }
    if (!problem.series.empty()) few.problems.push_back(std::move(problem));
  }
  if (!few.problems.empty()) return few;
  throw InputError(
      fmt::format("--rows {}: no row of the ladders has this in its name; give for example {}/{}",
                  rows, ladders.problems[0].name, ladders.problems[0].series[0].name));
}

}  // namespace pliant::accuracy

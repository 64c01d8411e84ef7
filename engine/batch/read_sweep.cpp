#include <fmt/format.h>
#include <toml++/toml.h>
#include <pliant/error.hpp>

#include <set>

#include "engine/batch/read_design.hpp"
#include "engine/batch/sweep.hpp"
#include "engine/case/reading/read_case.hpp"

namespace pliant::batch {

namespace {

Sweep::Slurm slurm_of(const toml::table& root) {
  Sweep::Slurm slurm;
  const toml::node* node = root.get("slurm");
  if (node == nullptr) return slurm;
  const toml::table* table = node->as_table();
  if (table == nullptr) refuse(*node, "`slurm` is no table", "write [slurm] with `options`");
  refuse_other_keys(*table, {"options", "runs_per_task"});
  slurm.options = texts_of(*table, "options", "options = [\"--partition=short\"]");
  const auto runs = value_of<std::int64_t>(*table, "runs_per_task", 0, "a whole number");
  if (runs < 0 || runs > 1'000'000) {
    refuse(*table, "runs_per_task is out of range", "give a number from 1, or leave it out");
  }
  slurm.runs_per_task = static_cast<int>(runs);
  return slurm;
}

}  // namespace

Sweep read_sweep(const std::filesystem::path& file) {
  const toml::table root = read_toml(file, "a sweep file");
  refuse_other_keys(root, {"case", "set", "time_limit", "retries", "slurm", "design"});
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  Sweep sweep;
  sweep.name = file.stem().string();
  const auto base = value_of<std::string>(root, "case", "", "the path of a case");
  if (base.empty()) refuse(root, "there is no base case", "write case = \"PATH\"");
  sweep.case_file = case_path(folder / base).lexically_normal();
  sweep.settings = texts_of(root, "set", "set = [\"time.end=0.1\"]");
  sweep.time_limit = value_of(root, "time_limit", 0.0, "a number of seconds");
  const auto retries = value_of<std::int64_t>(root, "retries", 0, "a whole number");
  if (sweep.time_limit < 0 || retries < 0 || retries > 100) {
    refuse(root, "time_limit or retries is out of range",
           "give a positive time_limit [s], and retries from 0 to 100");
  }
  sweep.retries = static_cast<int>(retries);
  sweep.slurm = slurm_of(root);
  const toml::array* designs = root["design"].as_array();
  if (designs == nullptr || !designs->is_array_of_tables()) {
    refuse(root, "there is no design", "write [[design]] with parameters.\"KEY\" = [VALUE, ...]");
  }
  std::set<std::string> names;
  for (const toml::node& design : *designs) {
    for (Assignment& run : read_design(*design.as_table(), folder)) {
      if (names.insert(name_of(run)).second) sweep.runs.push_back(std::move(run));
    }
  }
  return sweep;
}

}  // namespace pliant::batch

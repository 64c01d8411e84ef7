#include <fmt/format.h>
#include <toml++/toml.h>
#include <pliant/error.hpp>

#include <fstream>
#include <set>

#include "engine/batch/read_design.hpp"
#include "engine/batch/sweep.hpp"
#include "engine/case/read_case.hpp"

namespace pliant::batch {

namespace {

toml::table parsed(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) {
    throw InputError(
        fmt::format("{}: cannot be read; give the path of a sweep file", file.string()));
  }
  try {
    return toml::parse(stream, file.string());
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}:{}: {}; correct the TOML", file.string(),
                                 error.source().begin.line, error.description()));
  }
}

}  // namespace

Sweep read_sweep(const std::filesystem::path& file) {
  const toml::table root = parsed(file);
  refuse_other_keys(root, {"case", "set", "time_limit", "retries", "design"});
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  Sweep sweep;
  sweep.name = file.stem().string();
  const auto base = value_of<std::string>(root, "case", "", "the path of a case");
  if (base.empty()) refuse(root, "there is no base case", "write case = \"PATH\"");
  sweep.case_file = case_path(folder / base).lexically_normal();
  if (const toml::array* settings = root["set"].as_array()) {
    for (const toml::node& setting : *settings) {
      const auto text = setting.value<std::string>();
      if (!text) refuse(setting, "a setting is no text", "write set = [\"time.end=0.1\"]");
      sweep.settings.push_back(*text);
    }
  }
  sweep.time_limit = value_of(root, "time_limit", 0.0, "a number of seconds");
  const auto retries = value_of<std::int64_t>(root, "retries", 0, "a whole number");
  if (sweep.time_limit < 0 || retries < 0 || retries > 100) {
    refuse(root, "time_limit or retries is out of range",
           "give a positive time_limit [s], and retries from 0 to 100");
  }
  sweep.retries = static_cast<int>(retries);
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

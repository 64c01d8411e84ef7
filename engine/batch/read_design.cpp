#include "engine/batch/read_design.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "engine/batch/csv.hpp"
#include "engine/batch/sobol.hpp"

namespace pliant::batch {

void refuse(const toml::node& node, const std::string& what, const std::string& remedy) {
  throw InputError(fmt::format("{}: {}; {}", place_of(node).text(), what, remedy));
}

void refuse_other_keys(const toml::table& table, const std::vector<std::string_view>& known) {
  for (const auto& [key, value] : table) {
    if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
    refuse(value, fmt::format("there is no key `{}`", key.str()),
           suggestion(key.str(), known, "the keys are"));
  }
}

toml::table read_toml(const std::filesystem::path& file, std::string_view kind) {
  std::ifstream stream(file);
  if (!stream) {
    throw InputError(fmt::format("{}: cannot be read; give the path of {}", file.string(), kind));
  }
  try {
    return toml::parse(stream, file.string());
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}:{}: {}; correct the TOML", file.string(),
                                 error.source().begin.line, error.description()));
  }
}

std::vector<std::string> texts_of(const toml::table& table, std::string_view key,
                                  const std::string& example) {
  std::vector<std::string> texts;
  const toml::node* node = table.get(key);
  if (node == nullptr) return texts;
  const toml::array* list = node->as_array();
  if (list == nullptr) refuse(*node, fmt::format("`{}` is no list", key), "write " + example);
  for (const toml::node& one : *list) {
    const auto text = one.value<std::string>();
    if (!text) refuse(one, fmt::format("an entry of `{}` is no text", key), "write " + example);
    texts.push_back(*text);
  }
  return texts;
}

namespace {

constexpr int most_runs = 1'000'000;

int count_of(const toml::table& table, std::string_view key, int least) {
  const auto count = value_of<std::int64_t>(table, key, 0, "a whole number");
  if (count >= least && count <= most_runs) return static_cast<int>(count);
  refuse(table, fmt::format("`{}` is {}", key, count == 0 ? "missing" : fmt::format("{}", count)),
         fmt::format("give a whole number from {} to {}", least, most_runs));
}

std::string toml_of(const toml::node& node) {
  if (const auto number = node.value<double>(); number && !node.is_boolean()) {
    return number_text(*number);
  }
  std::ostringstream text;
  node.visit([&](const auto& value) {
    if constexpr (toml::is_table<decltype(value)>) {
      refuse(value, "a value is a table", "sweep over its keys, as in body.disc.material.density");
    } else {
      text << toml::toml_formatter(value);
    }
  });
  return text.str();
}

Interval interval_of(const std::string& key, const toml::table& table) {
  Interval interval{key, value_of(table, "from", std::nan(""), "a number"),
                    value_of(table, "to", std::nan(""), "a number"), false};
  const auto scale = value_of<std::string>(table, "scale", "linear", "\"linear\" or \"log\"");
  interval.logarithmic = scale == "log";
  if (!std::isfinite(interval.from) || !std::isfinite(interval.to)) {
    refuse(table, fmt::format("`{}` has no ends", key), "write { from = 1, to = 2 }");
  }
  if (scale != "linear" && scale != "log") {
    refuse(table, fmt::format("the scale of `{}` is \"{}\"", key, scale),
           "take \"linear\" or \"log\"");
  }
  if (interval.logarithmic && !(interval.from > 0 && interval.to > 0)) {
    refuse(table, fmt::format("`{}` has a logarithmic scale and an end that is not positive", key),
           "give positive ends, or scale = \"linear\"");
  }
  return interval;
}

ValueList list_of(const std::string& key, const toml::node& node) {
  ValueList list{key, {}};
  if (const toml::array* values = node.as_array()) {
    for (const toml::node& value : *values) list.values.push_back(toml_of(value));
  } else if (const toml::table* range = node.as_table()) {
    refuse_other_keys(*range, {"from", "to", "count", "scale"});
    const Interval interval = interval_of(key, *range);
    list = range_of(interval, count_of(*range, "count", 1));
  } else {
    list.values = {toml_of(node)};
  }
  if (list.values.empty()) refuse(node, fmt::format("`{}` has no values", key), "give one or more");
  return list;
}

const toml::table& parameters_of(const toml::table& design) {
  const toml::table* parameters = design["parameters"].as_table();
  if (parameters == nullptr || parameters->empty()) {
    refuse(design, "a design has no parameters",
           "write parameters.\"KEY\" = [VALUE, ...], with a key of the case");
  }
  return *parameters;
}

std::vector<ValueList> lists_of(const toml::table& design) {
  std::vector<ValueList> lists;
  for (const auto& [key, node] : parameters_of(design)) {
    lists.push_back(list_of(std::string(key.str()), node));
  }
  return lists;
}

std::vector<Assignment> zipped(const toml::table& design) {
  const auto lists = lists_of(design);
  for (const ValueList& list : lists) {
    if (list.values.size() == lists[0].values.size()) continue;
    refuse(design,
           fmt::format("`{}` has {} values and `{}` has {}", lists[0].key, lists[0].values.size(),
                       list.key, list.values.size()),
           "give as many, or kind = \"product\"");
  }
  return zip_of(lists);
}

std::vector<Assignment> sampled(const toml::table& design, const std::string& kind) {
  std::vector<Interval> intervals;
  for (const auto& [key, node] : parameters_of(design)) {
    const toml::table* range = node.as_table();
    if (range == nullptr) {
      refuse(node, fmt::format("`{}` is {}", key.str(), describe(node)),
             "write { from = 1, to = 2 }, with scale = \"log\" if you like");
    }
    refuse_other_keys(*range, {"from", "to", "scale"});
    intervals.push_back(interval_of(std::string(key.str()), *range));
  }
  const int samples = count_of(design, "samples", 1);
  const auto seed =
      static_cast<std::uint64_t>(value_of<std::int64_t>(design, "seed", 1, "a whole number"));
  if (kind == "latin_hypercube") return latin_hypercube(intervals, samples, seed);
  if (intervals.size() > SobolSequence::most_dimensions) {
    refuse(design, fmt::format("a Sobol design has {} parameters", intervals.size()),
           fmt::format("give at most {}, or kind = \"latin_hypercube\"",
                       SobolSequence::most_dimensions));
  }
  return sobol(intervals, samples, seed);
}

/// A value from a table: a number in its shortest form, or else the text itself.
std::string cell_text(const std::string& cell) {
  std::istringstream stream(cell);
  double number = 0;
  if (stream >> number && (stream >> std::ws).eof()) return number_text(number);
  return cell;
}

std::vector<Assignment> table_rows(const toml::table& design, const std::filesystem::path& folder) {
  const auto name = value_of<std::string>(design, "file", "", "the name of a CSV file");
  const std::filesystem::path file = folder / name;
  std::ifstream stream(file);
  if (name.empty() || !stream) {
    refuse(design, fmt::format("the table \"{}\" cannot be read", name),
           "give the name of a CSV file beside the sweep: file = \"runs.csv\"");
  }
  std::vector<CsvRow> rows;
  try {
    rows = read_csv(std::string(std::istreambuf_iterator<char>(stream), {}));
  } catch (const std::invalid_argument& error) {
    throw InputError(fmt::format("{}: {}; close it", file.string(), error.what()));
  }
  if (rows.size() < 2) {
    throw InputError(
        fmt::format("{}: the table has no rows; give a line with the keys, and one "
                    "for each run",
                    file.string()));
  }
  std::vector<Assignment> runs;
  runs.reserve(rows.size() - 1);
  for (std::size_t r = 1; r < rows.size(); ++r) {
    if (rows[r].size() != rows[0].size()) {
      throw InputError(fmt::format("{}: row {} has {} values for {} keys; give one for each",
                                   file.string(), r, rows[r].size(), rows[0].size()));
    }
    Assignment run;
    run.reserve(rows[0].size());
    for (std::size_t c = 0; c < rows[0].size(); ++c) {
      run.emplace_back(rows[0][c], cell_text(rows[r][c]));
    }
    runs.push_back(run);
  }
  return runs;
}

}  // namespace

std::vector<Assignment> read_design(const toml::table& design,
                                    const std::filesystem::path& folder) {
  const auto kind = value_of<std::string>(design, "kind", "product", "text");
  if (kind == "table") {
    refuse_other_keys(design, {"kind", "file"});
    return table_rows(design, folder);
  }
  if (kind == "latin_hypercube" || kind == "sobol") {
    refuse_other_keys(design, {"kind", "parameters", "samples", "seed"});
    return sampled(design, kind);
  }
  refuse_other_keys(design, {"kind", "parameters"});
  if (kind == "product") return product_of(lists_of(design));
  if (kind == "zip") return zipped(design);
  const std::vector<std::string_view> kinds = {"product", "zip", "table", "latin_hypercube",
                                               "sobol"};
  refuse(*design.get("kind"), fmt::format("there is no kind of design \"{}\"", kind),
         suggestion(kind, kinds, "the kinds are"));
}

}  // namespace pliant::batch

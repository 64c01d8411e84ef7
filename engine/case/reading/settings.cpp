#include "engine/case/reading/settings.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>

namespace pliant {
namespace {

/// One `--set` argument while it is inserted into the table.
struct Setting {
  Place place;
  std::vector<std::string> path;
  toml::table parsed;  ///< contains the value under "value", with the setting as its source
  Problems& problems;

  std::string path_to(std::size_t count) const {
    return fmt::format("{}", fmt::join(path.begin(), path.begin() + count, "."));
  }
  std::string path_from(std::size_t first) const {
    return fmt::format("{}", fmt::join(path.begin() + first, path.end(), "."));
  }
};

std::vector<std::string> split(std::string_view key) {
  std::vector<std::string> path;
  while (true) {
    const std::size_t dot = key.find('.');
    path.emplace_back(key.substr(0, dot));
    if (dot == std::string_view::npos) return path;
    key.remove_prefix(dot + 1);
  }
}

/// The value as TOML, or as text if it is not TOML.
std::optional<toml::table> parse_value(const std::string& value, const Place& place,
                                       Problems& problems) {
  try {
    toml::table parsed = toml::parse("value = " + value, std::string_view(place.file));
    if (parsed.size() == 1) return parsed;
  } catch (const toml::parse_error& error) {
    if (!value.empty() && std::string_view("[{\"'").find(value.front()) != std::string_view::npos) {
      problems.add(place, fmt::format("the value is not TOML: {}", error.description()),
                   "close every bracket and quote, and quote the whole argument in the shell");
      return std::nullopt;
    }
  }
  std::string quoted;
  for (const char c : value) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c == '\n' ? ' ' : c;
  }
  try {
    return toml::parse("value = \"" + quoted + "\"", std::string_view(place.file));
  } catch (const toml::parse_error&) {
    problems.add(place, "the value holds control characters, or bytes that are not UTF-8",
                 "write it in plain text");
    return std::nullopt;
  }
}

/// The element of `array` that `word` addresses: a position from 0, or the name of a table.
toml::node* find_element(toml::array& array, const std::string& word) {
  std::size_t position = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), position);
  if (error == std::errc() && end == word.data() + word.size()) return array.get(position);
  for (toml::node& element : array) {
    const toml::table* table = element.as_table();
    if (table && (*table)["name"].value<std::string_view>() == word) return &element;
  }
  return nullptr;
}

void report_missing_element(const Setting& setting, std::size_t depth, const toml::array& array) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < array.size(); ++i) {
    const toml::table* table = array.get(i)->as_table();
    const auto name = table ? (*table)["name"].value<std::string>() : std::nullopt;
    names.push_back(name ? *name : fmt::format("{}", i));
  }
  const std::vector<std::string_view> known(names.begin(), names.end());
  setting.problems.add(
      setting.place,
      fmt::format("`{}` has no element `{}`", setting.path_to(depth), setting.path[depth]),
      known.empty() ? "it is empty" : suggestion(setting.path[depth], known, "it has"));
}

/// Goes down from `node`, which `path[depth - 1]` names, and sets the value.
void place_value(toml::node& node, std::size_t depth, Setting& setting);

void place_in_table(toml::table& table, std::size_t depth, Setting& setting) {
  const std::string& word = setting.path[depth];
  toml::node& value = *setting.parsed.get("value");
  if (depth + 1 == setting.path.size()) {
    table.insert_or_assign(word, std::move(value));
    return;
  }
  if (!table.contains(word)) {
    // Parsed rather than constructed, so that the source of the new table is the setting.
    toml::table fresh = toml::parse("value = {}", std::string_view(setting.place.file));
    table.insert_or_assign(word, std::move(*fresh.get("value")));
  }
  place_value(*table.get(word), depth + 1, setting);
}

void place_in_array(toml::array& array, std::size_t depth, Setting& setting) {
  toml::node* element = find_element(array, setting.path[depth]);
  if (!element) return report_missing_element(setting, depth, array);
  if (depth + 1 < setting.path.size()) return place_value(*element, depth + 1, setting);
  for (auto position = array.begin(); position != array.end(); ++position) {
    if (&*position != element) continue;
    array.replace(position, std::move(*setting.parsed.get("value")));
    return;
  }
}

void place_value(toml::node& node, std::size_t depth, Setting& setting) {
  if (toml::table* table = node.as_table()) return place_in_table(*table, depth, setting);
  if (toml::array* array = node.as_array()) return place_in_array(*array, depth, setting);
  std::string remedy = fmt::format("set `{}` as a whole", setting.path_to(depth));
  if (const auto name = node.value<std::string>(); name && setting.path[depth - 1] == "material") {
    remedy += fmt::format(", or `material.{}.{}`", *name, setting.path_from(depth));
  }
  setting.problems.add(
      setting.place, fmt::format("`{}` is {}, not a table", setting.path_to(depth), describe(node)),
      remedy);
}

}  // namespace

void apply_settings(toml::table& root, std::span<const std::string> settings, Problems& problems) {
  for (const std::string& text : settings) {
    const Place place{fmt::format("{}{}", setting_mark, text)};
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
      problems.add(place, "a setting must have the form key=value",
                   "write it as in --set time.end=0.01");
      continue;
    }
    std::optional<toml::table> parsed = parse_value(text.substr(equals + 1), place, problems);
    if (!parsed) continue;
    Setting setting{place, split(text.substr(0, equals)), std::move(*parsed), problems};
    place_in_table(root, 0, setting);
  }
}

}  // namespace pliant

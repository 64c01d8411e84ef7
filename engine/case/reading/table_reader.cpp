#include "engine/case/reading/table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/case/reading/tables_with_key.hpp"

namespace pliant {

bool Entry::refuse(const std::string& what, const std::string& remedy) const {
  reading.problems.add(
      place_of(node), fmt::format("{} {}", key, what),
      remedy.empty() ? fmt::format("write it as in {} = {}", key, notes.example) : remedy);
  return false;
}

void TableReader::decided(std::string_view key, const toml::node& node, bool good) {
  if (!good) keys_are_known_ = false;
  const auto word = node.value<std::string_view>();
  if (good && word) decided_by_ = fmt::format("{} = \"{}\"", key, *word);
}

const toml::node* TableReader::find(std::string_view key, const Notes& notes) {
  known_.push_back(key);
  const toml::node* node = table_.get(key);
  if (node || !notes.required) return node;
  if (notes.decides) keys_are_known_ = false;
  missing_.push_back({key, notes.meaning, std::string(notes.example)});
  return nullptr;
}

const toml::node* TableReader::find_table(std::string_view key) {
  known_.push_back(key);
  const toml::node* node = table_.get(key);
  if (!node || node->is_table()) return node;
  reading_.problems.add(place_of(*node),
                        fmt::format("`{}` must be a table, found {}", key, describe(*node)),
                        fmt::format("write [{}] on a line of its own, its keys below", key));
  return nullptr;
}

const toml::array* TableReader::find_tables(std::string_view key) {
  known_.push_back(key);
  const toml::node* node = table_.get(key);
  if (!node) return nullptr;
  const toml::array* array = node->as_array();
  const bool good = array && std::all_of(array->begin(), array->end(),
                                         [](const toml::node& e) { return e.is_table(); });
  if (good) return array;
  reading_.problems.add(
      place_of(*node), fmt::format("`{}` must be a list of tables, found {}", key, describe(*node)),
      fmt::format("write [[{}]], with double brackets, before the keys of each", key));
  return nullptr;
}

void TableReader::finish() const {
  // A misspelt key is reported as one problem, not as an unknown key and a missing one.
  std::vector<std::string_view> meant;
  for (const auto& [key, node] : table_) {
    const bool is_known = std::find(known_.begin(), known_.end(), key.str()) != known_.end();
    if (is_known || !keys_are_known_) continue;
    meant.push_back(nearest_word(key.str(), known_));
    // A key from a setting has no source, but its value has.
    const Place place = key.source().path ? place_of(key) : place_of(node);
    reading_.problems.add(place, fmt::format("unknown key `{}` in {}", key.str(), title_),
                          remedy_for_unknown(key.str()));
  }
  for (const auto& [key, meaning, example] : missing_) {
    if (std::find(meant.begin(), meant.end(), key) != meant.end()) continue;
    reading_.problems.add(place_, fmt::format("{} lacks `{}`, {}", title_, key, meaning),
                          fmt::format("add {} = {}", key, example));
  }
}

std::string TableReader::remedy_for_unknown(std::string_view key) const {
  if (!decided_by_.empty()) {
    return suggestion(key, known_, fmt::format("with {} its keys are", decided_by_));
  }
  const std::string owners = tables_with_key(key, reading_.methods);
  if (owners.empty()) return suggestion(key, known_, "its keys are");
  return fmt::format("it is a key of {}", owners);
}

}  // namespace pliant

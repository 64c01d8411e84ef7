#pragma once

#include <fmt/format.h>

#include <toml++/toml.h>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/case/problems.hpp"
#include "engine/case/vocabulary/example.hpp"
#include "engine/case/vocabulary/key.hpp"
#include "engine/case/vocabulary/words.hpp"

/// Reading of TOML tables through the vocabulary: types, limits, lists of words, unknown keys.
namespace pliant {

/// What reading a value may need from the rest of the file.
struct Reading {
  Problems& problems;
  const toml::table& root;
  std::filesystem::path folder;  ///< folder that paths of other files are relative to
  int dimension = 2;
  std::vector<std::string> body_names;
  std::vector<std::string> boundary_names;
  std::vector<std::string> cut_names;
  std::vector<std::string> measurement_names;
  MethodList methods;
};

/// A key that is present.
struct Entry {
  std::string_view key;
  const toml::node& node;
  const Notes& notes;
  Reading& reading;

  /// Adds a problem at the value. Without a remedy, the key's example is the remedy.
  bool refuse(const std::string& what, const std::string& remedy = "") const;
};

/// Each reads `entry` into `value`, or adds a problem and returns false.
bool read(const Entry& entry, double& value);
bool read(const Entry& entry, int& value);
bool read(const Entry& entry, bool& value);
bool read(const Entry& entry, std::string& value);
bool read(const Entry& entry, Vector& value);
bool read(const Entry& entry, std::vector<double>& value);
bool read(const Entry& entry, Coefficients value);
bool read(const Entry& entry, PronyCase& value);
bool read(const Entry& entry, Expression& value);
bool read(const Entry& entry, std::optional<Expression>& value);
bool read(const Entry& entry, VectorExpression& value);
bool read(const Entry& entry, std::optional<VectorExpression>& value);
bool read(const Entry& entry, Name value);
bool read(const Entry& entry, FilePath value);
bool read(const Entry& entry, MethodWord value);
bool read(const Entry& entry, NumberOrWord value);
bool read(const Entry& entry, Choice value);
bool read(const Entry& entry, CflRule value);
bool read(const Entry& entry, Dissipation value);
bool read(const Entry& entry, RemeshRule value);
bool read(const Entry& entry, AxisSet value);
bool read(const Entry& entry, Direction value);
bool read(const Entry& entry, AngularVelocity value);
bool read(const Entry& entry, BodyName value);
bool read(const Entry& entry, BodyPair value);
bool read(const Entry& entry, BoundaryName value);
bool read(const Entry& entry, CutName value);
bool read(const Entry& entry, MeasurementName value);
bool read(const Entry& entry, MeasurementNames value);
bool read(const Entry& entry, WallFriction value);
bool read(const Entry& entry, FieldName value);
bool read(const Entry& entry, std::optional<RigidRotation>& value);
bool read(const Entry& entry, std::optional<WallRotation>& value);
bool read(const Entry& entry, std::optional<StressExpression>& value);
bool read(const Entry& entry, Axis& value);
bool read(const Entry& entry, ShapeWord& value);
bool read(const Entry& entry, Shape& value);
bool read(const Entry& entry, std::vector<Shape>& value);
bool read(const Entry& entry, MaterialCase& value);

/// The word of `entry` as a value of its enumeration; otherwise -1, with a problem. `or_else`
/// completes the list of words in messages with other values that the key accepts.
int read_word(const Entry& entry, std::span<const Word> known, std::string_view or_else = {});

template <class E>
requires std::is_enum_v<E>
bool read(const Entry& entry, E& value) {
  const int word = read_word(entry, words<E>);
  if (word >= 0) value = static_cast<E>(word);
  return word >= 0;
}

/// Visits the keys of one table of the file.
class TableReader {
 public:
  /// `title` is the name of the table in messages: "[time]", "geometry".
  TableReader(const toml::table& table, std::string title, Place place, Reading& reading)
      : table_(table), title_(std::move(title)), place_(std::move(place)), reading_(reading) {}

  template <class Value>
  bool operator()(std::string_view key, Value&& value, const Notes& notes) {
    const std::string example = example_in<Value>(notes.example, reading_.dimension);
    Notes here = notes;
    here.example = example;
    const toml::node* node = find(key, here);
    if (!node) return !notes.required;
    const bool good = read(Entry{key, *node, here, reading_}, value);
    if (notes.decides) decided(key, *node, good);
    return good;
  }

  template <class Keys>
  void table(std::string_view key, std::string_view, Keys&& keys) {
    static const toml::table empty;
    const toml::node* node = find_table(key);
    if (!node && table_.contains(key)) return;
    const toml::table& inner = node ? *node->as_table() : empty;
    TableReader reader(inner, fmt::format("[{}]", key), node ? place_of(*node) : place_, reading_);
    keys(reader);
    reader.finish();
  }

  template <class Keys>
  void optional_table(std::string_view key, std::string_view meaning, bool, Keys&& keys) {
    known_.push_back(key);
    if (table_.contains(key)) table(key, meaning, keys);
  }

  template <class Element, class Keys>
  void list(std::string_view key, std::string_view, std::vector<Element>& elements, Keys&& keys) {
    const toml::array* tables = find_tables(key);
    if (!tables) return;
    elements.resize(tables->size());
    for (std::size_t i = 0; i < tables->size(); ++i) {
      const toml::table& inner = *tables->get(i)->as_table();
      TableReader reader(inner, fmt::format("[[{}]]", key), place_of(inner), reading_);
      keys(reader, elements[i]);
      reader.finish();
    }
  }

  /// Checks every [key.NAME], whether or not a body refers to it.
  void materials(std::string_view key, std::string_view meaning);

  int dimension() const { return reading_.dimension; }
  MethodList methods() const { return reading_.methods; }

  /// Reports missing required keys, and keys that were not visited.
  void finish() const;

 private:
  /// Stores the value that decides which keys the table has, for messages.
  void decided(std::string_view key, const toml::node& node, bool good);
  /// The value of `key`; null if it is missing.
  const toml::node* find(std::string_view key, const Notes& notes);
  /// Null if there is no such table; adds a problem if `key` is something else.
  const toml::node* find_table(std::string_view key);
  const toml::array* find_tables(std::string_view key);

  /// The table that has this key, the key that was meant, or all keys.
  std::string remedy_for_unknown(std::string_view key) const;

  const toml::table& table_;
  std::string title_;
  Place place_;
  Reading& reading_;
  std::vector<std::string_view> known_;
  struct Missing {
    std::string_view key, meaning;
    std::string example;
  };
  std::vector<Missing> missing_;
  bool keys_are_known_ = true;
  std::string decided_by_;  ///< the word that decides which keys the table has
};

}  // namespace pliant

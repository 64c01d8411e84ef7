#include "engine/case/writing/schema.hpp"

#include <fmt/format.h>

#include <utility>

#include "engine/case/vocabulary/vocabulary.hpp"
#include "engine/case/writing/value_schema.hpp"

namespace pliant {
namespace {

std::string word_meanings(std::span<const Word> known) {
  std::string text;
  for (const Word& word : known) {
    if (!word.meaning.empty()) text += fmt::format("\n\n\"{}\": {}", word.text, word.meaning);
  }
  return text;
}

std::string description_of(const Notes& notes) {
  std::string text(notes.meaning);
  if (!notes.unit.empty()) text += fmt::format(" [{}]", notes.unit);
  if (notes.limits.text != finite.text) text += fmt::format("; {}", notes.limits.text);
  if (!notes.example.empty()) text += fmt::format("\n\nExample: {}", notes.example);
  return text;
}

/// The keys of a table, and which of them are required.
struct Keys {
  Schema properties = Schema::object();
  Schema required = Schema::array();

  Schema table() const {
    Schema schema = {{"type", "object"}, {"properties", properties}};
    if (!required.empty()) schema["required"] = required;
    schema["additionalProperties"] = false;
    return schema;
  }
};

/// Visits the keys of a table once for each value of its deciding key.
class TableSchema {
 public:
  template <class Value>
  bool operator()(std::string_view key, Value&& value, const Notes& notes) {
    using Plain = std::remove_cvref_t<Value>;
    Schema schema = schema_of(value, notes.limits);
    std::string description = description_of(notes);
    if constexpr (std::is_enum_v<Plain>) {
      description += word_meanings(words<Plain>);
      if (notes.decides) {
        deciding_key_ = key;
        choices_.assign(words<Plain>.begin(), words<Plain>.end());
        keys_.resize(choices_.size());
        value = static_cast<Plain>(choices_[choice_].value);
      }
    }
    if constexpr (std::is_same_v<Plain, Choice>) description += word_meanings(value.known);
    if constexpr (std::is_same_v<Plain, MethodWord>) {
      description += word_meanings(words_of(value.known));
    }
    // Draft 7 ignores everything next to a reference.
    if (schema.contains("$ref")) schema = {{"allOf", Schema::array({schema})}};
    schema["description"] = description;
    keys_[choice_].properties[std::string(key)] = schema;
    if (notes.required) keys_[choice_].required.push_back(key);
    return true;
  }

  int dimension() const { return 3; }

  template <class Visit>
  Schema walk(Visit&& keys) {
    do {
      keys(*this);
    } while (++choice_ < choices_.size());
    return choices_.empty() ? keys_[0].table() : table_with_choices();
  }

 private:
  // Editors complete from the keys of all choices; the branches admit those of the actual choice.
  Schema table_with_choices() const {
    Keys all;
    Schema branches = Schema::array();
    for (std::size_t i = 0; i < choices_.size(); ++i) {
      for (const auto& [key, schema] : keys_[i].properties.items()) {
        if (!all.properties.contains(key))
          all.properties[key] = schema;
        else if (all.properties[key] != schema)
          all.properties[key] = true;
      }
      const Schema taken = {{"properties", {{deciding_key_, {{"const", choices_[i].text}}}}},
                            {"required", Schema::array({deciding_key_})}};
      branches.push_back({{"if", taken}, {"then", keys_[i].table()}});
    }
    all.required.push_back(deciding_key_);
    Schema schema = all.table();
    schema["allOf"] = branches;
    return schema;
  }

  std::string deciding_key_;
  std::vector<Word> choices_;
  std::size_t choice_ = 0;
  std::vector<Keys> keys_{1};  ///< of each choice
};

template <class Element, class Visit>
Schema schema_of_table(Visit&& keys) {
  return TableSchema().walk([&](auto& visit) {
    Element element;
    keys(visit, element);
  });
}

/// Visits the whole case.
class CaseSchema {
 public:
  explicit CaseSchema(MethodList methods) : methods_(methods) {}

  template <class Value>
  bool operator()(std::string_view key, Value&& value, const Notes& notes) {
    return top_level_(key, value, notes);
  }

  template <class Visit>
  void table(std::string_view key, std::string_view meaning, Visit&& keys) {
    add(key, meaning, TableSchema().walk(keys));
  }

  template <class Visit>
  void optional_table(std::string_view key, std::string_view meaning, bool, Visit&& keys) {
    table(key, meaning, keys);
  }

  template <class Element, class Visit>
  void list(std::string_view key, std::string_view meaning, std::vector<Element>&, Visit&& keys) {
    add(key, meaning, {{"type", "array"}, {"items", schema_of_table<Element>(keys)}});
  }

  void materials(std::string_view key, std::string_view meaning) {
    add(key, meaning, {{"type", "object"}, {"additionalProperties", defined("material")}});
  }

  void add(std::string_view key, std::string_view meaning, Schema schema) {
    schema["description"] = meaning;
    tables_[std::string(key)] = std::move(schema);
  }

  int dimension() const { return 3; }
  MethodList methods() const { return methods_; }

  Schema schema(const Schema& definitions) {
    Schema whole = top_level_.walk([](auto&) {});
    whole["properties"].update(tables_);
    whole["definitions"] = definitions;
    return whole;
  }

 private:
  MethodList methods_;
  TableSchema top_level_;
  Schema tables_ = Schema::object();
};

Schema definitions() {
  return {{"geometry", schema_of_table<Shape>([](auto& visit, Shape& e) { shape_keys(visit, e); })},
          {"material", schema_of_table<MaterialCase>(
                           [](auto& visit, MaterialCase& e) { material_keys(visit, e); })},
          {"prony",
           schema_of_table<PronyCase>([](auto& visit, PronyCase& e) { prony_keys(visit, e); })},
          {"dissipation", schema_of_table<DissipationCase>(
                              [](auto& visit, DissipationCase& e) { dissipation_keys(visit, e); })},
          {"rotation", schema_of_table<RigidRotation>(
                           [](auto& visit, RigidRotation& e) { rotation_keys(visit, e); })},
          {"wall_rotation", schema_of_table<WallRotation>([](auto& visit, WallRotation& e) {
             wall_rotation_keys(visit, e);
           })},
          {"stress", schema_of_table<StressExpression>(
                         [](auto& visit, StressExpression& e) { stress_keys(visit, e); })}};
}

}  // namespace

std::string case_schema_json(MethodList methods) {
  CaseSchema visitor(methods);
  Case a_case;
  case_keys(visitor, a_case);
  Schema schema = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                   {"title", "Case file of pliant"}};
  schema.update(visitor.schema(definitions()));
  return schema.dump(1) + "\n";
}

}  // namespace pliant

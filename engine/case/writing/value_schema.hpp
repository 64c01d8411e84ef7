#pragma once

#include <nlohmann/json.hpp>

#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "engine/case/vocabulary/key.hpp"
#include "engine/case/vocabulary/measurable_fields.hpp"
#include "engine/case/vocabulary/words.hpp"

/// The JSON Schema of the value of a key, by the type of its place in `Case`.
namespace pliant {

using Schema = nlohmann::ordered_json;

/// A reference to a table that the schema defines under this name.
inline Schema defined(std::string_view name) {
  return {{"$ref", "#/definitions/" + std::string(name)}};
}

inline Schema text_schema() { return {{"type", "string"}}; }
inline Schema name_schema() { return {{"type", "string"}, {"pattern", "^[A-Za-z0-9_-]+$"}}; }

/// A number inside limits, or a text with a formula, which only the reader evaluates.
inline Schema number_schema(const Limits& limits, std::string_view type = "number") {
  Schema number = {{"type", type}};
  if (limits.lower > -unlimited) {
    number[limits.lower_included ? "minimum" : "exclusiveMinimum"] = limits.lower;
  }
  if (limits.upper < unlimited) {
    number[limits.upper_included ? "maximum" : "exclusiveMaximum"] = limits.upper;
  }
  return {{"anyOf", {number, text_schema()}}};
}

inline Schema list_of(const Schema& element, int least) {
  return {{"type", "array"}, {"items", element}, {"minItems", least}};
}

inline Schema vector_of(const Schema& component) {
  Schema vector = list_of(component, 2);
  vector["maxItems"] = 3;
  return vector;
}

/// A number, a formula, or a word.
inline Schema number_or(std::string_view word, const Limits& limits,
                        std::string_view type = "number") {
  Schema schema = number_schema(limits, type);
  schema["anyOf"].insert(schema["anyOf"].begin() + 1, Schema{{"const", word}});
  return schema;
}

inline Schema one_of(std::span<const Word> known) {
  Schema texts = Schema::array();
  for (const Word& word : known) texts.push_back(word.text);
  return {{"enum", texts}};
}

inline Schema schema_of(const double&, const Limits& limits) { return number_schema(limits); }
inline Schema schema_of(const int&, const Limits& limits) {
  return number_schema(limits, "integer");
}
inline Schema schema_of(const bool&, const Limits&) { return {{"type", "boolean"}}; }
inline Schema schema_of(const std::string&, const Limits&) { return text_schema(); }
inline Schema schema_of(const Vector&, const Limits& limits) {
  return vector_of(number_schema(limits));
}
inline Schema schema_of(const std::vector<double>&, const Limits& limits) {
  return list_of(number_schema(limits), 1);
}
inline Schema schema_of(const Coefficients&, const Limits& limits) {
  return list_of(number_schema(limits), 1);
}
inline Schema schema_of(const PronyCase&, const Limits&) { return defined("prony"); }
inline Schema schema_of(const Expression&, const Limits&) { return number_schema(finite); }
inline Schema schema_of(const std::optional<Expression>&, const Limits&) {
  return number_schema(finite);
}
inline Schema schema_of(const VectorExpression&, const Limits&) {
  return vector_of(number_schema(finite));
}
inline Schema schema_of(const std::optional<VectorExpression>&, const Limits&) {
  return vector_of(number_schema(finite));
}
inline Schema schema_of(const Name&, const Limits&) { return name_schema(); }
inline Schema schema_of(const FilePath&, const Limits&) { return text_schema(); }
inline Schema schema_of(const MethodWord& value, const Limits&) {
  return one_of(words_of(value.known));
}
inline Schema schema_of(const NumberOrWord& value, const Limits& limits) {
  return number_or(value.word, limits);
}
inline Schema schema_of(const Choice& value, const Limits&) { return one_of(value.known); }
inline Schema schema_of(const CflRule&, const Limits& limits) { return number_schema(limits); }
inline Schema schema_of(const Dissipation&, const Limits& limits) {
  Schema schema = number_schema(limits);
  schema["anyOf"].push_back(defined("dissipation"));
  return schema;
}
inline Schema schema_of(const RemeshRule&, const Limits& limits) {
  Schema schema = number_or("adaptive", limits, "integer");
  schema["anyOf"].insert(schema["anyOf"].begin() + 2, Schema{{"const", "never"}});
  return schema;
}
inline Schema schema_of(const AxisSet&, const Limits&) { return list_of(one_of(words<Axis>), 1); }
inline Schema schema_of(const Direction&, const Limits&) {
  return vector_of(number_schema(finite));
}
inline Schema schema_of(const AngularVelocity&, const Limits&) {
  Schema schema = number_schema(finite);
  schema["anyOf"].push_back(vector_of(number_schema(finite)));
  return schema;
}
inline Schema schema_of(const BodyName&, const Limits&) { return name_schema(); }
inline Schema schema_of(const BodyPair&, const Limits&) {
  Schema pair = list_of(name_schema(), 2);
  pair["maxItems"] = 2;
  return pair;
}
inline Schema schema_of(const BoundaryName&, const Limits&) { return name_schema(); }
inline Schema schema_of(const CutName&, const Limits&) { return name_schema(); }
inline Schema schema_of(const MeasurementName&, const Limits&) { return name_schema(); }
inline Schema schema_of(const MeasurementNames&, const Limits&) {
  return list_of(name_schema(), 1);
}
inline Schema schema_of(const WallFriction&, const Limits& limits) {
  Schema schema = number_schema(limits);
  Schema& choices = schema["anyOf"];
  choices.insert(choices.begin() + 1, one_of(wall_frictions()));
  return schema;
}
inline Schema schema_of(const FieldName&, const Limits&) {
  Schema names = Schema::array();
  for (const MeasurableField& field : measurable_fields) names.push_back(field.name);
  return {{"enum", names}};
}
inline Schema schema_of(const std::optional<RigidRotation>&, const Limits&) {
  return defined("rotation");
}
inline Schema schema_of(const std::optional<WallRotation>&, const Limits&) {
  return defined("wall_rotation");
}
inline Schema schema_of(const std::optional<StressExpression>&, const Limits&) {
  return defined("stress");
}
inline Schema schema_of(const Shape&, const Limits&) { return defined("geometry"); }
inline Schema schema_of(const std::vector<Shape>&, const Limits&) {
  return list_of(defined("geometry"), 2);
}
inline Schema schema_of(const MaterialCase&, const Limits&) {
  return {{"anyOf", {defined("material"), name_schema()}}};
}

template <class E>
requires std::is_enum_v<E>
inline Schema schema_of(const E&, const Limits&) { return one_of(words<E>); }

}  // namespace pliant

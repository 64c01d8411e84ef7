#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "engine/case/vocabulary/key.hpp"
#include "engine/case/vocabulary/words.hpp"

/// Writes values as TOML text, the reverse of table_reader.hpp. An empty text means that the key
/// has no value and is not written.
namespace pliant {

/// The case that names refer to.
struct Writing {
  const Case& a_case;
  int dimension;
};

std::string toml_text(double value, const Writing&);
std::string toml_text(int value, const Writing&);
std::string toml_text(bool value, const Writing&);
std::string toml_text(const std::string& value, const Writing&);
std::string toml_text(const Vector& value, const Writing&);
std::string toml_text(const std::vector<double>& value, const Writing&);
std::string toml_text(Coefficients value, const Writing&);
std::string toml_text(PronyCase& value, const Writing&);
std::string toml_text(const Expression& value, const Writing&);
std::string toml_text(const std::optional<Expression>& value, const Writing&);
std::string toml_text(const VectorExpression& value, const Writing&);
std::string toml_text(const std::optional<VectorExpression>& value, const Writing&);
std::string toml_text(Name value, const Writing&);
std::string toml_text(FilePath value, const Writing&);
std::string toml_text(MethodWord value, const Writing&);
std::string toml_text(NumberOrWord value, const Writing&);
std::string toml_text(Choice value, const Writing&);
std::string toml_text(CflRule value, const Writing&);
std::string toml_text(Dissipation value, const Writing&);
std::string toml_text(RemeshRule value, const Writing&);
std::string toml_text(AxisSet value, const Writing&);
std::string toml_text(Direction value, const Writing&);
std::string toml_text(AngularVelocity value, const Writing&);
std::string toml_text(BodyName value, const Writing&);
std::string toml_text(BodyPair value, const Writing&);
std::string toml_text(BoundaryName value, const Writing&);
std::string toml_text(CutName value, const Writing&);
std::string toml_text(MeasurementName value, const Writing&);
std::string toml_text(const MeasurementNames& value, const Writing&);
std::string toml_text(WallFriction value, const Writing&);
std::string toml_text(FieldName value, const Writing&);
std::string toml_text(std::optional<RigidRotation>& value, const Writing&);
std::string toml_text(std::optional<WallRotation>& value, const Writing&);
std::string toml_text(std::optional<StressExpression>& value, const Writing&);
std::string toml_text(Shape& value, const Writing&);
std::string toml_text(std::vector<Shape>& value, const Writing&);
std::string toml_text(MaterialCase& value, const Writing&);

template <class E>
requires std::is_enum_v<E> std::string toml_text(E value, const Writing&) {
  return fmt::format("\"{}\"", text_of(value));
}

/// Visits the keys of one table and stores a line `key = value` for each.
class TableWriter {
 public:
  explicit TableWriter(Writing writing) : writing_(writing) {}

  template <class Value>
  bool operator()(std::string_view key, Value&& value, const Notes&) {
    const std::string text = toml_text(value, writing_);
    if (!text.empty()) lines_.push_back(fmt::format("{} = {}", key, text));
    return true;
  }

  template <class Keys>
  void table(std::string_view key, std::string_view, Keys&& keys) {
    TableWriter writer(writing_);
    keys(writer);
    lines_.push_back(fmt::format("\n[{}]", key));
    append(writer);
  }

  template <class Keys>
  void optional_table(std::string_view key, std::string_view meaning, bool present, Keys&& keys) {
    if (present) table(key, meaning, keys);
  }

  template <class Element, class Keys>
  void list(std::string_view key, std::string_view, std::vector<Element>& elements, Keys&& keys) {
    for (Element& element : elements) {
      TableWriter writer(writing_);
      keys(writer, element);
      lines_.push_back(fmt::format("\n[[{}]]", key));
      append(writer);
    }
  }

  /// Writes nothing: every body contains its material.
  void materials(std::string_view, std::string_view) {}

  int dimension() const { return writing_.dimension; }
  MethodList methods() const {
    const MethodRules* rules = writing_.a_case.rules;
    return rules != nullptr ? MethodList(rules, 1) : MethodList();
  }

  std::string joined(std::string_view separator) const;

 private:
  void append(const TableWriter& inner) {
    lines_.insert(lines_.end(), inner.lines_.begin(), inner.lines_.end());
  }

  Writing writing_;
  std::vector<std::string> lines_;
};

}  // namespace pliant

#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "engine/case/vocabulary/key.hpp"
#include "engine/case/vocabulary/words.hpp"
#include "engine/case/writing/toml_text.hpp"

/// Writing of the reference page: one table of keys in Markdown.
namespace pliant {

inline std::string joined_words(std::span<const Word> known) {
  std::string texts;
  for (const Word& word : known) {
    texts += fmt::format("{}`\"{}\"`", texts.empty() ? "" : ", ", word.text);
  }
  return texts;
}

inline std::string type_of(const double&) { return "number"; }
inline std::string type_of(const int&) { return "whole number"; }
inline std::string type_of(const bool&) { return "true or false"; }
inline std::string type_of(const std::string&) { return "text"; }
inline std::string type_of(const Vector&) { return "vector"; }
inline std::string type_of(const std::vector<double>&) { return "list of numbers"; }
inline std::string type_of(const Coefficients&) { return "list of numbers"; }
inline std::string type_of(const PronyCase&) { return "table"; }
inline std::string type_of(const Expression&) { return "number or formula"; }
inline std::string type_of(const std::optional<Expression>&) { return "formula"; }
inline std::string type_of(const VectorExpression&) { return "vector of numbers or formulas"; }
inline std::string type_of(const std::optional<VectorExpression>&) {
  return "vector of numbers or formulas";
}
inline std::string type_of(const Name&) { return "name"; }
inline std::string type_of(const FilePath&) { return "path of a file"; }
inline std::string type_of(const MethodWord& value) { return joined_words(words_of(value.known)); }
inline std::string type_of(const NumberOrWord& value) {
  return fmt::format("number or `\"{}\"`", value.word);
}
inline std::string type_of(const Choice& value) { return joined_words(value.known); }
inline std::string type_of(const CflRule&) { return "number"; }
inline std::string type_of(const Dissipation&) { return "table or number"; }
inline std::string type_of(const RemeshRule&) {
  return R"(whole number, `"adaptive"` or `"never"`)";
}
inline std::string type_of(const AxisSet&) { return "list of axes"; }
inline std::string type_of(const Direction&) { return "vector, of any length"; }
inline std::string type_of(const AngularVelocity&) { return "number or vector"; }
inline std::string type_of(const BodyName&) { return "name of a body"; }
inline std::string type_of(const BodyPair&) { return "list of two names of bodies"; }
inline std::string type_of(const BoundaryName&) { return "name of a boundary"; }
inline std::string type_of(const CutName&) { return "name of a cut"; }
inline std::string type_of(const MeasurementName&) { return "name of a measurement"; }
inline std::string type_of(const MeasurementNames&) { return "list of names of measurements"; }
std::string type_of(const WallFriction&);
inline std::string type_of(const FieldName&) { return "name of a field"; }
inline std::string type_of(const std::optional<RigidRotation>&) { return "table"; }
inline std::string type_of(const std::optional<WallRotation>&) { return "table"; }
inline std::string type_of(const std::optional<StressExpression>&) { return "table"; }
inline std::string type_of(const Shape&) { return "table"; }
inline std::string type_of(const std::vector<Shape>&) { return "list of tables"; }
inline std::string type_of(const MaterialCase&) { return "name or table"; }

template <class E>
requires std::is_enum_v<E>
inline std::string type_of(const E&) { return joined_words(words<E>); }

/// Visits the keys of a table once for each value of its deciding key, and stores a row for each
/// key.
///
/// The page shows vectors in 3D, and the defaults of a case without bodies.
class TableDescriber {
 public:
  template <class Value>
  bool operator()(std::string_view key, Value&& value, const Notes& notes) {
    using Plain = std::remove_cvref_t<Value>;
    std::string type = type_of(value);
    if (notes.limits.text != finite.text) type += fmt::format(", {}", notes.limits.text);
    if constexpr (std::is_enum_v<Plain>) {
      if (notes.decides) {
        type = "one of the words below";
        choices_.assign(words<Plain>.begin(), words<Plain>.end());
        value = static_cast<Plain>(choices_[choice_].value);
      } else {
        list_words(key, words<Plain>);
      }
    }
    if constexpr (std::is_same_v<Plain, Choice>) list_words(key, value.known);
    if constexpr (std::is_same_v<Plain, MethodWord>) list_words(key, words_of(value.known));
    std::string fallback = "required";
    if (!notes.required) {
      const std::string text = toml_text(value, Writing{empty_case(), dimension()});
      fallback = text.empty() || text == "\"\"" ? "" : fmt::format("`{}`", text);
    }
    add_row(key, fmt::format("{} | {} | {} | {} |", type, notes.unit, fallback, notes.meaning));
    return true;
  }

  int dimension() const { return 3; }

  /// Lets `keys` visit this until each value of the deciding key was used once.
  template <class Keys>
  void walk(Keys&& keys) {
    do {
      keys(*this);
    } while (++choice_ < choices_.size());
  }

  std::string text() const;

 private:
  struct Row {
    std::string key, columns;
    std::vector<std::string_view> choices;  ///< values of the deciding key that have this row
  };

  static const Case& empty_case();
  void add_row(std::string_view key, const std::string& columns);
  void list_words(std::string_view key, std::span<const Word> known);
  std::string choices_of(const Row& row) const;

  std::vector<Row> rows_;
  std::vector<Word> choices_;
  std::size_t choice_ = 0;
  std::vector<std::string> word_lists_;
};

}  // namespace pliant

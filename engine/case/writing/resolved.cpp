#include "engine/case/writing/resolved.hpp"

#include <fmt/format.h>

#include <utility>

#include "engine/case/checks/stability.hpp"
#include "engine/case/vocabulary/vocabulary.hpp"
#include "engine/case/writing/toml_text.hpp"

namespace pliant {
namespace {

/// [a, b] in 2D, [a, b, c] in 3D.
template <class Element>
std::string list_text(const std::array<Element, 3>& values, const Writing& writing) {
  std::string text;
  for (int i = 0; i < writing.dimension; ++i) {
    text += (i == 0 ? "" : ", ") + toml_text(values[i], writing);
  }
  return "[" + text + "]";
}

template <class Element>
std::string name_at(const std::vector<Element>& elements, int index, const Writing& writing) {
  const auto at = static_cast<std::size_t>(index);
  return at < elements.size() ? toml_text(elements[at].name, writing) : "";
}

template <class Keys>
std::string inline_table(const Writing& writing, Keys&& keys) {
  TableWriter writer(writing);
  keys(writer);
  return "{ " + writer.joined(", ") + " }";
}

}  // namespace

std::string TableWriter::joined(std::string_view separator) const {
  std::string text;
  for (const std::string& line : lines_) {
    if (&line != &lines_.front()) text += separator;
    text += line;
  }
  return text;
}

/// The shortest decimals that read back bitwise.
std::string toml_text(double value, const Writing&) { return fmt::format("{}", value); }

std::string toml_text(int value, const Writing&) { return fmt::format("{}", value); }

std::string toml_text(bool value, const Writing&) { return value ? "true" : "false"; }

std::string toml_text(const std::string& value, const Writing&) {
  std::string text = "\"";
  for (const char c : value) {
    if (c == '"' || c == '\\') {
      text += '\\';
      text += c;
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      text += fmt::format("\\u{:04X}", static_cast<unsigned char>(c));
    } else {
      text += c;
    }
  }
  return text + '"';
}

std::string toml_text(const Vector& value, const Writing& writing) {
  return list_text(value, writing);
}

std::string toml_text(const std::vector<double>& value, const Writing&) {
  if (value.empty()) return "";
  std::string text;
  for (const double number : value) text += fmt::format("{}{}", text.empty() ? "" : ", ", number);
  return "[" + text + "]";
}

std::string toml_text(Coefficients value, const Writing& writing) {
  return toml_text(std::as_const(value.list), writing);
}

std::string toml_text(PronyCase& value, const Writing& writing) {
  if (value.ratios.empty()) return "";
  return inline_table(writing, [&](auto& keys) { prony_keys(keys, value); });
}

std::string toml_text(const Expression& value, const Writing& writing) {
  return value.is_constant() ? toml_text(value(0), writing) : toml_text(value.text(), writing);
}

std::string toml_text(const std::optional<Expression>& value, const Writing& writing) {
  return value ? toml_text(*value, writing) : "";
}

std::string toml_text(const VectorExpression& value, const Writing& writing) {
  return list_text(value, writing);
}

std::string toml_text(const std::optional<VectorExpression>& value, const Writing& writing) {
  return value ? list_text(*value, writing) : "";
}

std::string toml_text(Name value, const Writing& writing) {
  return value.text.empty() ? "" : toml_text(value.text, writing);
}

std::string toml_text(FilePath value, const Writing& writing) {
  return value.text.empty() ? "" : toml_text(value.text, writing);
}

std::string toml_text(MethodWord value, const Writing& writing) {
  return toml_text(std::as_const(value.word), writing);
}

std::string toml_text(NumberOrWord value, const Writing& writing) {
  return value.number ? toml_text(*value.number, writing) : fmt::format("\"{}\"", value.word);
}

std::string toml_text(Choice value, const Writing&) {
  return fmt::format("\"{}\"", text_of(value.known, value.value));
}

std::string toml_text(CflRule, const Writing& writing) {
  return toml_text(cfl_number(writing.a_case), writing);
}

std::string toml_text(Dissipation value, const Writing& writing) {
  return inline_table(writing, [&](auto& keys) { dissipation_keys(keys, value.strengths); });
}

std::string toml_text(RemeshRule value, const Writing& writing) {
  using Policy = decltype(Case::remeshing)::Policy;
  if (value.remeshing.policy == Policy::adaptive) return "\"adaptive\"";
  if (value.remeshing.policy == Policy::never) return "\"never\"";
  return toml_text(value.remeshing.every, writing);
}

std::string toml_text(AxisSet value, const Writing&) {
  std::string text;
  for (const Word& axis : words<Axis>) {
    if (!value.axis[axis.value]) continue;
    text += fmt::format("{}\"{}\"", text.empty() ? "" : ", ", axis.text);
  }
  return "[" + text + "]";
}

std::string toml_text(Direction value, const Writing& writing) {
  return list_text(value.vector, writing);
}

std::string toml_text(AngularVelocity value, const Writing& writing) {
  return writing.dimension == 2 ? toml_text(value.vector[2], writing)
                                : list_text(value.vector, writing);
}

std::string toml_text(BodyName value, const Writing& writing) {
  return name_at(writing.a_case.bodies, value.index, writing);
}

std::string toml_text(BodyPair value, const Writing& writing) {
  return fmt::format("[{}, {}]", name_at(writing.a_case.bodies, value.indices[0], writing),
                     name_at(writing.a_case.bodies, value.indices[1], writing));
}

std::string toml_text(BoundaryName value, const Writing& writing) {
  return name_at(writing.a_case.boundaries, value.index, writing);
}

std::string toml_text(CutName value, const Writing& writing) {
  return name_at(writing.a_case.cuts, value.index, writing);
}

std::string toml_text(MeasurementName value, const Writing& writing) {
  return name_at(writing.a_case.measurements, value.index, writing);
}

std::string toml_text(const MeasurementNames& value, const Writing& writing) {
  std::string text;
  for (const int index : value.indices) {
    text += (text.empty() ? "" : ", ") + name_at(writing.a_case.measurements, index, writing);
  }
  return "[" + text + "]";
}

std::string toml_text(WallFriction value, const Writing& writing) {
  const BoundaryCase& boundary = value.boundary;
  return boundary.friction_coefficient ? toml_text(*boundary.friction_coefficient, writing)
                                       : toml_text(boundary.friction, writing);
}

std::string toml_text(FieldName value, const Writing& writing) {
  return toml_text(value.field, writing);
}

std::string toml_text(std::optional<RigidRotation>& value, const Writing& writing) {
  if (!value) return "";
  return inline_table(writing, [&](auto& keys) { rotation_keys(keys, *value); });
}

std::string toml_text(std::optional<WallRotation>& value, const Writing& writing) {
  if (!value) return "";
  return inline_table(writing, [&](auto& keys) { wall_rotation_keys(keys, *value); });
}

std::string toml_text(std::optional<StressExpression>& value, const Writing& writing) {
  if (!value) return "";
  return inline_table(writing, [&](auto& keys) { stress_keys(keys, *value); });
}

std::string toml_text(Shape& value, const Writing& writing) {
  return inline_table(writing, [&](auto& keys) { shape_keys(keys, value); });
}

std::string toml_text(std::vector<Shape>& value, const Writing& writing) {
  std::string text;
  for (Shape& shape : value) text += (text.empty() ? "" : ", ") + toml_text(shape, writing);
  return "[" + text + "]";
}

std::string toml_text(MaterialCase& value, const Writing& writing) {
  return inline_table(writing, [&](auto& keys) { material_keys(keys, value); });
}

std::string resolved_toml(const Case& a_case) {
  // The vocabulary needs places to write to, for the reader.
  Case copy = a_case;
  TableWriter writer(Writing{a_case, a_case.dimension});
  case_keys(writer, copy);
  return writer.joined("\n") + "\n";
}

}  // namespace pliant

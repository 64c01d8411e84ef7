#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <stdexcept>

#include "engine/case/reading/table_reader.hpp"

/// Reading of numbers and formulas, alone and in lists.
namespace pliant {
namespace {

/// A number, or a text with a constant formula such as "1/32". `why` explains a failure.
std::optional<double> number_in(const toml::node& node, std::string& why) {
  if (const auto number = node.value<double>(); number && node.is_number()) return number;
  why = "found " + describe(node);
  const auto text = node.value<std::string>();
  if (!text) return std::nullopt;
  try {
    const Expression formula(*text);
    if (formula.is_constant()) return formula(0);
    why += ", which is not constant";
  } catch (const std::invalid_argument& error) {
    why += fmt::format(": {}", error.what());
  }
  return std::nullopt;
}

bool read_number(const Entry& entry, const toml::node& node, double& value) {
  std::string why;
  const std::optional<double> number = number_in(node, why);
  if (!number) return entry.refuse("must be a number, " + why);
  if (std::isinf(*number) && !entry.notes.limits.admit(*number)) {
    return entry.refuse(fmt::format("must be finite, got {}", *number));
  }
  if (!entry.notes.limits.admit(*number)) {
    return entry.refuse(fmt::format("must be {}, got {}", entry.notes.limits.text, *number),
                        std::string(entry.notes.remedy));
  }
  value = *number;
  return true;
}

bool read_formula(const Entry& entry, const toml::node& node, Expression& value) {
  const auto text = node.value<std::string>();
  if (!text) {
    double number = 0;
    if (!node.is_number())
      return entry.refuse("must be a number or a formula, found " + describe(node));
    if (!read_number(entry, node, number)) return false;
    value = Expression(number);
    return true;
  }
  const std::string variables = fmt::format("{}", fmt::join(entry.notes.variables, ", "));
  try {
    value = Expression(*text);
  } catch (const std::invalid_argument& error) {
    return entry.refuse(
        fmt::format("has the formula \"{}\": {}", *text, error.what()),
        fmt::format("formulas consist of numbers, {}, pi, + - * / ^, comparisons, "
                    "?:, &&, || and functions such as sin, exp, sqrt, abs, min, max",
                    variables));
  }
  for (const char variable : std::string_view("xyzt")) {
    if (!value.uses(variable) || entry.notes.variables.find(variable) != std::string::npos)
      continue;
    return entry.refuse(fmt::format("has the formula \"{}\", which uses {}", *text, variable),
                        fmt::format("here formulas may use {} only", variables));
  }
  return true;
}

/// The list at `entry` if it has one element for each direction; otherwise null, with a problem.
const toml::array* components(const Entry& entry) {
  const int dimension = entry.reading.dimension;
  const std::string shape = dimension == 2 ? "[x, y]" : "[x, y, z]";
  const toml::array* list = entry.node.as_array();
  if (!list) {
    entry.refuse("must be a list of numbers, found " + describe(entry.node));
  } else if (list->size() != static_cast<std::size_t>(dimension)) {
    entry.refuse(fmt::format("needs {} components for dimension = {}, got {}", dimension, dimension,
                             list->size()),
                 "give " + shape);
    return nullptr;
  }
  return list;
}

}  // namespace

bool read(const Entry& entry, double& value) { return read_number(entry, entry.node, value); }

bool read(const Entry& entry, int& value) {
  double number = 0;
  if (!read_number(entry, entry.node, number)) return false;
  if (number != std::floor(number) || std::abs(number) > 1e9) {
    return entry.refuse(fmt::format("must be a whole number, got {}", number));
  }
  value = static_cast<int>(number);
  return true;
}

bool read(const Entry& entry, Vector& value) {
  const toml::array* list = components(entry);
  if (!list) return false;
  bool good = true;
  for (std::size_t i = 0; i < list->size(); ++i) {
    good = read_number(entry, *list->get(i), value[i]) && good;
  }
  return good;
}

bool read(const Entry& entry, std::vector<double>& value) {
  const toml::array* list = entry.node.as_array();
  if (!list) return entry.refuse("must be a list of numbers, found " + describe(entry.node));
  if (list->empty()) return entry.refuse("is empty, but must contain a number");
  value.resize(list->size());
  for (std::size_t i = 0; i < list->size(); ++i) {
    if (!read_number(entry, *list->get(i), value[i])) return false;
  }
  return true;
}

bool read(const Entry& entry, Coefficients value) {
  const toml::array* list = entry.node.as_array();
  if (list && (list->empty() || list->size() > 5)) {
    return entry.refuse(fmt::format("has {} numbers, but must have one to five", list->size()),
                        "give C_10 up to at most C_50");
  }
  if (!read(entry, value.list)) return false;
  if (value.list.front() > 0) return true;
  return entry.refuse(fmt::format("must start with a positive C_10, got {}", value.list.front()),
                      "the shear modulus is 2 C_10");
}

bool read(const Entry& entry, Expression& value) { return read_formula(entry, entry.node, value); }

bool read(const Entry& entry, std::optional<Expression>& value) {
  return read_formula(entry, entry.node, value.emplace());
}

bool read(const Entry& entry, VectorExpression& value) {
  const toml::array* list = components(entry);
  if (!list) return false;
  bool good = true;
  for (std::size_t i = 0; i < list->size(); ++i) {
    good = read_formula(entry, *list->get(i), value[i]) && good;
  }
  return good;
}

bool read(const Entry& entry, NumberOrWord value) {
  if (entry.node.value<std::string_view>() == value.word) {
    value.number.reset();
    return true;
  }
  std::string why;
  if (!number_in(entry.node, why)) {
    return entry.refuse(
        fmt::format("must be a number or \"{}\", found {}", value.word, describe(entry.node)),
        fmt::format("write {0} = \"{1}\", or {2} as in {0} = {3}", entry.key, value.word,
                    value.noun, entry.notes.example));
  }
  return read(entry, value.number.emplace());
}

bool read(const Entry& entry, CflRule value) { return read(entry, value.cfl.emplace()); }

bool read(const Entry& entry, RemeshRule value) {
  using Policy = decltype(Case::remeshing)::Policy;
  const auto text = entry.node.value<std::string_view>();
  std::string why;
  if (text == "adaptive" || text == "never") {
    value.remeshing.policy = text == "never" ? Policy::never : Policy::adaptive;
    return true;
  }
  if (!number_in(entry.node, why)) {
    return entry.refuse(R"(must be a number of steps, "adaptive" or "never", found )" +
                        describe(entry.node));
  }
  value.remeshing.policy = Policy::every;
  return read(entry, value.remeshing.every);
}

bool read(const Entry& entry, Direction value) {
  Vector given{};
  if (!read(entry, given)) return false;
  const double length = std::hypot(given[0], given[1], given[2]);
  if (length == 0) return entry.refuse("must not be zero");
  // A unit vector is not changed, so that a resolved case reads back bitwise.
  const bool is_unit = std::abs(length - 1) < 1e-15;
  for (std::size_t i = 0; i < 3; ++i) value.vector[i] = is_unit ? given[i] : given[i] / length;
  return true;
}

bool read(const Entry& entry, AngularVelocity value) {
  if (entry.reading.dimension == 3) return read(entry, value.vector);
  return read(entry, value.vector[2]);
}

bool read(const Entry& entry, std::optional<VectorExpression>& value) {
  return read(entry, value.emplace());
}

bool read(const Entry& entry, WallFriction value) {
  BoundaryCase& boundary = value.boundary;
  if (!entry.node.is_number()) {
    const int word = read_word(entry, wall_frictions(), ", or a coefficient");
    if (word >= 0) boundary.friction = static_cast<ContactLaw>(word);
    return word >= 0;
  }
  boundary.friction = ContactLaw::no_slip;
  return read(entry, boundary.friction_coefficient.emplace());
}

}  // namespace pliant

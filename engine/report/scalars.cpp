#include "engine/report/scalars.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

namespace pliant::report {
namespace {

constexpr std::string_view axes = "xyz";

std::string words_of(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

Scalar whole(const StoredField& field) {
  Scalar scalar{.name = field.name, .label = words_of(field.name), .unit = {}, .field = field.name};
  if (field.components == 3) {
    scalar.kind = Scalar::Kind::magnitude;
    scalar.label += ", magnitude";
  } else if (field.components == 6) {
    scalar.kind = Scalar::Kind::von_mises;
    scalar.name = fmt::format("von_mises_{}", field.name);
    scalar.label = fmt::format("von Mises {}", field.name);
  }
  return scalar;
}

/// Body numbers and particle kinds are integers and are not shown.
bool is_shown(const StoredField& field) {
  return !field.integer &&
         (field.components <= 1 || field.components == 3 || field.components == 6);
}

int rank_of(const Scalar& scalar) {
  constexpr std::array<std::string_view, 4> first = {"displacement", "velocity", "von_mises_stress",
                                                     "pressure"};
  return static_cast<int>(std::ranges::find(first, scalar.name) - first.begin());
}

std::optional<Scalar> component_named(const std::string& name, const StoredField& field) {
  const auto stem = field.name + "_";
  if (field.components != 3 || name.size() != stem.size() + 1 || !name.starts_with(stem)) return {};
  const auto axis = axes.find(name.back());
  if (axis == axes.npos) return {};
  return Scalar{.name = name,
                .label = fmt::format("{} along {}", words_of(field.name), name.back()),
                .unit = {},
                .field = field.name,
                .kind = Scalar::Kind::component,
                .component = static_cast<int>(axis)};
}

}  // namespace

std::vector<Scalar> default_scalars(const std::vector<StoredField>& fields) {
  std::vector<Scalar> scalars;
  scalars.reserve(fields.size());
  for (const auto& field : fields) {
    if (is_shown(field)) scalars.push_back(whole(field));
  }
  std::ranges::stable_sort(scalars, {}, rank_of);
  return scalars;
}

Scalar scalar_named(const std::string& name, const std::vector<StoredField>& fields) {
  std::string known;
  for (const auto& field : fields) {
    if (!is_shown(field)) continue;
    if (auto component = component_named(name, field)) return *component;
    Scalar scalar = whole(field);
    if (scalar.name == name) return scalar;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", scalar.name);
    if (field.components == 3) known += fmt::format(", {}_x", scalar.name);
  }
  throw InputError(
      fmt::format("--field {}: the result has no such field; choose one of {}", name, known));
}

float value_of(const Scalar& scalar, const float* c) {
  switch (scalar.kind) {
    case Scalar::Kind::value:
      return c[0];
    case Scalar::Kind::component:
      return c[scalar.component];
    case Scalar::Kind::magnitude:
      return std::hypot(c[0], c[1], c[2]);
    case Scalar::Kind::von_mises:
      break;
  }
  // Components xx, yy, zz, xy, yz, xz.
  const float normal =
      (c[0] - c[1]) * (c[0] - c[1]) + (c[1] - c[2]) * (c[1] - c[2]) + (c[2] - c[0]) * (c[2] - c[0]);
  const float shear = c[3] * c[3] + c[4] * c[4] + c[5] * c[5];
  return std::sqrt(0.5F * normal + 3 * shear);
}

}  // namespace pliant::report

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engine/case/checks/check.hpp"

// What a case requires and its method cannot do.
namespace pliant {

void refuse_tables(const Check& check, std::initializer_list<std::string_view> tables) {
  for (const std::string_view key : tables) {
    const toml::node* node = check.root.get(key);
    if (!node || (node->is_table() && node->as_table()->empty())) continue;
    const std::string title =
        node->is_array() ? fmt::format("[[{}]]", key) : fmt::format("[{}]", key);
    check.problems.add(check.place(key, ""),
                       fmt::format("method \"{}\" has no {}", check.a_case.method, title),
                       "leave the table out, or choose another method");
  }
}

void refuse_boundaries(const Check& check, BoundaryCase::Kind kind) {
  for (std::size_t i = 0; i < check.a_case.boundaries.size(); ++i) {
    if (check.a_case.boundaries[i].kind != kind) continue;
    check.problems.add(check.place("boundary", i, "kind"),
                       fmt::format("method \"{}\" has no boundaries of kind \"{}\"",
                                   check.a_case.method, row_of(kind).word),
                       "use another kind, or choose another method");
  }
}

void refuse_key(const Check& check, std::string_view key) {
  const toml::node* node = check.root.get(key);
  if (!node) return;
  check.problems.add(place_of(*node),
                     fmt::format("method \"{}\" has no {}", check.a_case.method, key),
                     "leave the key out, or choose another method");
}

void refuse_measurements(const Check& check, bool (*is_measured)(MeasurementCase::Kind kind)) {
  std::vector<std::string_view> measured;
  for (const MeasurementKind& row : measurement_kinds) {
    if (is_measured(row.kind)) measured.push_back(row.word);
  }
  for (std::size_t i = 0; i < check.a_case.measurements.size(); ++i) {
    const MeasurementKind& row = row_of(check.a_case.measurements[i].kind);
    if (is_measured(row.kind) || row.sampling == Sampling::from_history) continue;
    check.problems.add(
        check.place("measurement", i, "kind"),
        fmt::format("method \"{}\" does not measure \"{}\"", check.a_case.method, row.word),
        fmt::format("measure one of {}, or choose another method", fmt::join(measured, ", ")));
  }
}

void refuse_prony_shear(const Check& check) {
  for (std::size_t i = 0; i < check.a_case.bodies.size(); ++i) {
    if (check.a_case.bodies[i].material_as_given.prony_shear.ratios.empty()) continue;
    check.problems.add(
        check.place("body", i, "material"),
        fmt::format("method \"{}\" has no materials with prony_shear", check.a_case.method),
        "leave it out, or take method = \"total_lagrangian\" or \"point_based\"");
  }
}

const MethodRules* rules_of(MethodList methods, std::string_view word) {
  for (const MethodRules& method : methods) {
    if (method.word == word) return &method;
  }
  return nullptr;
}

std::vector<std::string> warnings_of_method(const Case& a_case) {
  std::vector<std::string> warnings;
  if (a_case.rules != nullptr && a_case.rules->warn != nullptr)
    a_case.rules->warn(a_case, warnings);
  return warnings;
}

// A case with tables of several methods, including its own, is for comparisons with --set method=.
void check_method(const Check& check) {
  const bool compares = check.root.contains(check.a_case.method);
  for (const MethodRules& method : check.methods) {
    if (method.word == check.a_case.method) {
      if (!method.remeshes) refuse_tables(check, {"remeshing", "level_set", "ghosts"});
      method.check(check);
    } else if (!compares) {
      refuse_tables(check, {method.word});
    }
  }
}

}  // namespace pliant

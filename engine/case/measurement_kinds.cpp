#include "engine/case/measurement_kinds.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/case/method_rules.hpp"

namespace pliant {

std::string_view unit_of_field(const Case&, const MeasurementCase& m) {
  const auto field = std::find_if(measurable_fields.begin(), measurable_fields.end(),
                                  [&](const MeasurableField& f) { return f.name == m.field; });
  return field == measurable_fields.end() ? "1" : field->unit;
}

std::string_view unit_of_source(const Case& a_case, const MeasurementCase& m) {
  return unit_of(a_case, a_case.measurements[m.of]);
}

std::string_view unit_of_terms(const Case& a_case, const MeasurementCase& m) {
  return m.terms.empty() ? "1" : unit_of(a_case, a_case.measurements[m.terms.front()]);
}

std::string_view unit_of(const Case& a_case, const MeasurementCase& m) {
  const KindUnit& unit = row_of(m.kind).unit;
  if (m.relative) return "1";
  if (unit.other) return unit.other(a_case, m);
  return a_case.dimension == 2 ? unit.in_2d : unit.in_3d;
}

std::string sampling_warning(const Case& a_case) {
  if (a_case.output.measure_every > 0 || a_case.rules == nullptr || a_case.rules->remeshes) {
    return {};
  }
  std::string means, from_two_values;
  for (const MeasurementCase& m : a_case.measurements) {
    if (m.kind == MeasurementCase::Kind::weighted_sum) continue;
    const Sampling sampling = row_of(m.kind).sampling;
    if (sampling == Sampling::value) continue;
    std::string& names = sampling == Sampling::rate ? means : from_two_values;
    names += fmt::format("{}`{}`", names.empty() ? "" : ", ", m.name);
  }
  if (means.empty() && from_two_values.empty()) return {};
  return fmt::format(
      "measurements are taken at the start and at the end only{}{}; set output.measure_every, as "
      "in output.measure_every = {:g}",
      means.empty() ? ""
                    : fmt::format(", so that the force {} is its mean over the whole run", means),
      from_two_values.empty()
          ? ""
          : fmt::format(", so that {} has a history of two values", from_two_values),
      a_case.time.end / 100);
}

}  // namespace pliant

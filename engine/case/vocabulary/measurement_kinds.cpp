#include "engine/case/vocabulary/measurement_kinds.hpp"

#include <algorithm>

#include "engine/case/vocabulary/measurable_fields.hpp"

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

bool depends_on_samples(const Case& a_case) {
  return std::ranges::any_of(a_case.measurements, [](const MeasurementCase& m) {
    return m.kind != MeasurementCase::Kind::weighted_sum &&
           row_of(m.kind).sampling != Sampling::value;
  });
}

}  // namespace pliant

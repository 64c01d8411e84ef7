#include "engine/case/vocabulary/measurement_kinds.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/case/method_rules.hpp"
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

namespace {

/// Names of the measurements that depend on the times of samples.
struct Sampled {
  std::string rates, from_history;
  bool none() const { return rates.empty() && from_history.empty(); }
};

Sampled sampled(const Case& a_case) {
  Sampled found;
  for (const MeasurementCase& m : a_case.measurements) {
    if (m.kind == MeasurementCase::Kind::weighted_sum) continue;
    const Sampling sampling = row_of(m.kind).sampling;
    if (sampling == Sampling::value) continue;
    std::string& names = sampling == Sampling::rate ? found.rates : found.from_history;
    names += fmt::format("{}`{}`", names.empty() ? "" : ", ", m.name);
  }
  return found;
}

std::string warning_of(const Case& a_case, const Sampled& names, const std::string& when,
                       const std::string& duration, const std::string& number) {
  return fmt::format(
      "measurements are taken {}{}{}; set output.measure_every, as in output.measure_every = {:g}",
      when,
      names.rates.empty()
          ? ""
          : fmt::format(", so that the force {} is its mean over {}", names.rates, duration),
      names.from_history.empty()
          ? ""
          : fmt::format(", so that {} has a history of {} values", names.from_history, number),
      a_case.time.end / 100);
}

}  // namespace

std::string sampling_warning(const Case& a_case) {
  if (a_case.output.measure_every > 0 || a_case.rules == nullptr || is_remeshed(a_case)) {
    return {};
  }
  const Sampled names = sampled(a_case);
  if (names.none()) return {};
  return warning_of(a_case, names, "at the start and at the end only", "the whole run", "two");
}

std::string sampling_warning(const Case& a_case, const std::vector<double>& times) {
  constexpr double dense = 0.05;  // longest time between samples, as a share of the run
  if (a_case.output.measure_every > 0 || !is_remeshed(a_case) || times.size() < 2) {
    return {};
  }
  double longest = 0;
  for (std::size_t i = 1; i < times.size(); ++i) {
    longest = std::max(longest, times[i] - times[i - 1]);
  }
  const Sampled names = sampled(a_case);
  if (names.none() || longest <= dense * a_case.time.end) return {};
  return warning_of(a_case, names,
                    fmt::format("at remeshings and at the end only, up to {:.2g} s apart", longest),
                    fmt::format("the last {:.2g} s", times.back() - times[times.size() - 2]),
                    fmt::format("{}", times.size()));
}

}  // namespace pliant

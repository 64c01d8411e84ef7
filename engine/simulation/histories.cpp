#include "engine/simulation/histories.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <utility>

#include "engine/case/vocabulary/measurement_kinds.hpp"
#include "engine/simulation/oscillation.hpp"
#include "engine/simulation/pulse.hpp"

namespace pliant {

namespace {

using Samples = std::span<const double>;

double smallest(Samples values) {
  double least = std::numeric_limits<double>::quiet_NaN();
  for (const double value : values) least = std::fmin(least, value);
  return least;
}

double largest(Samples values) {
  double most = std::numeric_limits<double>::quiet_NaN();
  for (const double value : values) most = std::fmax(most, value);
  return most;
}

/// Linear interpolation between two samples.
double value_at(double time, Samples times, Samples values) {
  constexpr double rounding = 1e-12;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (times[i] < time * (1 - rounding)) continue;
    if (i == 0 || times[i] == times[i - 1]) return values[i];
    const double part = std::min((time - times[i - 1]) / (times[i] - times[i - 1]), 1.0);
    return values[i - 1] + part * (values[i] - values[i - 1]);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// Functions for the kinds of measurement that evaluate the history of another one.
struct HistoryFunction {
  MeasurementCase::Kind kind;
  double (*evaluate)(const MeasurementCase& m, Samples times, Samples values);
};

constexpr HistoryFunction functions[] = {
    {MeasurementCase::Kind::period,
     [](const MeasurementCase&, Samples t, Samples f) { return oscillation_period(t, f); }},
    {MeasurementCase::Kind::amplitude_ratio,
     [](const MeasurementCase&, Samples t, Samples f) { return amplitude_ratio(t, f); }},
    {MeasurementCase::Kind::peak_moving_average,
     [](const MeasurementCase& m, Samples t, Samples f) {
       return peak_moving_average(t, f, m.window);
     }},
    {MeasurementCase::Kind::last_time_above,
     [](const MeasurementCase& m, Samples t, Samples f) {
       return last_time_above(t, f, m.fraction);
     }},
    {MeasurementCase::Kind::smallest,
     [](const MeasurementCase&, Samples, Samples f) { return smallest(f); }},
    {MeasurementCase::Kind::largest,
     [](const MeasurementCase&, Samples, Samples f) { return largest(f); }},
    {MeasurementCase::Kind::value_at_time,
     [](const MeasurementCase& m, Samples t, Samples f) { return value_at(m.time, t, f); }},
};

double evaluate_history(const MeasurementCase& m, Samples times, Samples values) {
  for (const HistoryFunction& function : functions) {
    if (function.kind == m.kind) return function.evaluate(m, times, values);
  }
  assert(false);
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

void Histories::add(double time, std::vector<double> values) {
  if (start_.empty()) start_ = latest_ = values;
  const std::vector<double> before = std::exchange(latest_, values);
  const double elapsed = times_.empty() ? 0 : time - times_.back();
  times_.push_back(time);
  const auto sampling = [this](std::size_t m) {
    return row_of(settings_->measurements[m].kind).sampling;
  };
  for (std::size_t m = 0; m < values.size(); ++m) {
    if (settings_->measurements[m].relative) values[m] /= start_[m];
    if (sampling(m) == Sampling::rate) {
      values[m] = elapsed > 0 ? (values[m] - before[m]) / elapsed : 0;
    }
    rows_[m].push_back(values[m]);
  }
  for (std::size_t m = 0; m < values.size(); ++m) {
    const MeasurementCase& measurement = settings_->measurements[m];
    if (sampling(m) != Sampling::from_history) continue;
    rows_[m].back() = measurement.kind == MeasurementCase::Kind::weighted_sum
                          ? weighted_sum(measurement)
                          : evaluate_history(measurement, times_, rows_[measurement.of]);
  }
}

double Histories::weighted_sum(const MeasurementCase& m) const {
  double sum = 0;
  for (std::size_t i = 0; i < m.terms.size(); ++i) {
    sum += (m.factors.empty() ? 1 : m.factors[i]) * rows_[m.terms[i]].back();
  }
  return sum;
}

// Without a value, measurements that evaluate the history have none for the same reason.
std::string Histories::why_missing(std::size_t m) const {
  const MeasurementCase& measurement = settings_->measurements[m];
  if (std::isfinite(rows_[m].back())) return "";
  std::vector<int> sources = measurement.terms;
  if (measurement.of >= 0) sources.push_back(measurement.of);
  for (const int source : sources) {
    const std::string why = why_missing(static_cast<std::size_t>(source));
    if (why.empty()) continue;
    return fmt::format("measurement `{}` has none: {}", settings_->measurements[source].name, why);
  }
  if (measurement.relative && !(start_[m] != 0)) return "the value at the start is zero";
  const std::string_view reason = row_of(measurement.kind).missing;
  return std::string(reason.empty() ? "the value is not finite" : reason);
}

void Histories::put(ArchiveWriter& archive) const {
  archive.put("histories/time", std::span<const double>(times_));
  archive.put("histories/start", std::span<const double>(start_));
  archive.put("histories/latest", std::span<const double>(latest_));
  for (std::size_t m = 0; m < rows_.size(); ++m) {
    archive.put(fmt::format("histories/{}", settings_->measurements[m].name),
                std::span<const double>(rows_[m]));
  }
}

void Histories::get(const ArchiveReader& archive) {
  times_ = archive.get<double>("histories/time");
  start_ = archive.get<double>("histories/start");
  latest_ = archive.get<double>("histories/latest");
  for (std::size_t m = 0; m < rows_.size(); ++m) {
    rows_[m] = archive.get<double>(fmt::format("histories/{}", settings_->measurements[m].name));
  }
}

}  // namespace pliant

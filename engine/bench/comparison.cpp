#include "engine/bench/comparison.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>

namespace pliant::bench {

namespace {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return (values[(n - 1) / 2] + values[n / 2]) / 2;
}

double median_of(const RecordedRow& row,
                 const std::function<double(const RecordedSample&)>& figure) {
  std::vector<double> values;
  values.reserve(row.samples.size());
  for (const RecordedSample& sample : row.samples) values.push_back(figure(sample));
  return median(values);
}

Change change_of(const RecordedRow& before, const RecordedRow& after, double tolerance) {
  const auto rate = [](const RecordedSample& s) { return s.rate; };
  const auto of_peak = [](const RecordedSample& s) { return s.rate / s.fma_peak; };
  const auto of_triad = [](const RecordedSample& s) { return s.rate / s.triad; };
  Change change{after.name, after.particles, after.threads, median_of(before, rate),
                median_of(after, rate)};
  change.over_peak = median_of(after, of_peak) / median_of(before, of_peak);
  change.over_triad = median_of(after, of_triad) / median_of(before, of_triad);
  const auto [least, most] = std::minmax(change.over_peak, change.over_triad);
  if (most < 1 - tolerance) change.verdict = Verdict::slower;
  if (least > 1 + tolerance) change.verdict = Verdict::faster;
  return change;
}

}  // namespace

std::string_view text_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::slower:
      return "slower";
    case Verdict::faster:
      return "faster";
    case Verdict::same:
      break;
  }
  return "same";
}

std::vector<Change> changes(const Record& before, const Record& after, double tolerance) {
  std::vector<Change> found;
  for (const RecordedRow& row : after.rows) {
    const auto old = std::ranges::find(before.rows, row.name, &RecordedRow::name);
    if (old != before.rows.end()) found.push_back(change_of(*old, row, tolerance));
  }
  return found;
}

std::string text_of(const std::vector<Change>& changes, double tolerance) {
  std::string text = fmt::format("{:<52}{:>8}{:>8}{:>8}{:>8}  {}\n", "row", "before", "now",
                                 "/peak", "/triad", "verdict");
  for (const Change& change : changes) {
    text += fmt::format("{:<52}{:>8.2f}{:>8.2f}{:>8.3f}{:>8.3f}  {}\n", change.name,
                        1e-6 * change.before, 1e-6 * change.after, change.over_peak,
                        change.over_triad, text_of(change.verdict));
  }
  return text + fmt::format(
                    "M/s before and now; ratio of the shares of the FMA peak and of the "
                    "triad. Slower: both below {:.3g}.\n",
                    1 - tolerance);
}

std::string markdown_of(const std::vector<Change>& changes, double tolerance) {
  std::string text =
      "| row | particles | threads | before [M/s] | now [M/s] | over FMA peak | over triad | "
      "verdict |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const Change& change : changes) {
    text += fmt::format("| {} | {} | {} | {:.2f} | {:.2f} | {:.3f} | {:.3f} | {} |\n", change.name,
                        change.particles, change.threads, 1e-6 * change.before, 1e-6 * change.after,
                        change.over_peak, change.over_triad, text_of(change.verdict));
  }
  return text + fmt::format(
                    "\nMillion particle-stages a second, and ratios now/before of their "
                    "shares of what the machine gave beside them. Slower: both ratios "
                    "are below {:.3g}.\n",
                    1 - tolerance);
}

Interval typical_ratio(std::span<const double> ratios) {
  const std::size_t n = ratios.size();
  std::vector<double> means;  // Walsh averages
  means.reserve(n * (n + 1) / 2);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) means.push_back(std::log(ratios[i] * ratios[j]) / 2);
  }
  std::sort(means.begin(), means.end());
  const double value = std::exp(median(means));
  constexpr double quantile = 3.2905;  // of the normal distribution, with 0.05 % in each tail
  const double count = static_cast<double>(n);
  const double rank =
      count * (count + 1) / 4 - quantile * std::sqrt(count * (count + 1) * (2 * count + 1) / 24);
  if (rank < 1) return {value, 0, std::numeric_limits<double>::infinity()};
  const auto outside = static_cast<std::size_t>(rank);
  return {value, std::exp(means[outside - 1]), std::exp(means[means.size() - outside])};
}

Verdict judge(const Interval& ratio, double tolerance) {
  if (ratio.upper < 1 - tolerance) return Verdict::slower;
  if (ratio.lower > 1 + tolerance) return Verdict::faster;
  return Verdict::same;
}

double share_of(const std::string& text, std::string_view option) {
  double value = -1;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  const std::string_view unit(rest, static_cast<std::size_t>(end - rest));
  if (unit == "%") value /= 100;
  const bool is_share = value >= 0 && value < 1;
  if (error == std::errc() && (unit == "%" || unit.empty()) && is_share) return value;
  throw InputError(
      fmt::format("{} {}: give a share from 0 to below 100 %, as in 10%", option, text));
}

}  // namespace pliant::bench

#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/bench/record.hpp"

/// Whether a program is slower than another one, or than before.
namespace pliant::bench {

enum class Verdict { same, slower, faster };
std::string_view text_of(Verdict verdict);

/// Ratio of the speed of a row to that in an earlier record. Both are divided by the speed of the
/// machine at the time of each repetition, and are medians over the repetitions.
struct Change {
  std::string name;
  std::int64_t particles = 0;
  int threads = 1;
  double before = 0, after = 0;  ///< [particle-stages/s]
  double over_peak = 1;          ///< ratio of the shares of the FMA peak
  double over_triad = 1;         ///< ratio of the shares of the triad
  Verdict verdict = Verdict::same;
};

/// Rows that both records have. A row is slower if both ratios are below 1 - tolerance, and faster
/// if both are above 1 + tolerance. On another or a busy machine, neither figure may describe what
/// limits a row.
std::vector<Change> changes(const Record& before, const Record& after, double tolerance);

std::string text_of(const std::vector<Change>& changes, double tolerance);
std::string markdown_of(const std::vector<Change>& changes, double tolerance);

/// An estimate with its confidence interval.
struct Interval {
  double value, lower, upper;
};

/// The typical value of a ratio that was measured several times: the Hodges-Lehmann estimate of the
/// logarithms, with the interval of Wilcoxon's signed-rank test at a confidence of 99.9 %, from its
/// normal approximation. Outliers hardly affect it. With fewer than 15 ratios the interval has no
/// bounds. Requires at least one.
Interval typical_ratio(std::span<const double> ratios);

/// Slower if the whole interval is below 1 - tolerance, faster if it is above 1 + tolerance.
Verdict judge(const Interval& ratio, double tolerance);

/// "10%" or "0.1" as 0.1. Throws InputError that names the option.
double share_of(const std::string& text, std::string_view option);

}  // namespace pliant::bench

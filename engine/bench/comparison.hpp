#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/bench/record.hpp"

/// Whether a program is slower than another one, or than it was.
namespace pliant::bench {

enum class Verdict { same, slower, faster };
std::string_view text_of(Verdict verdict);

/// Speed of a row over that of the same row in an earlier record. Both figures are divided by what
/// the machine gave beside each repetition; medians over the repetitions.
struct Change {
  std::string name;
  std::int64_t particles = 0;
  int threads = 1;
  double before = 0, after = 0;  ///< [particle-stages/s]
  double over_peak = 1;          ///< ratio of the shares of the FMA peak
  double over_triad = 1;         ///< ratio of the shares of the triad
  Verdict verdict = Verdict::same;
};

/// Rows that both records have. A row is slower where both ratios are below 1 - tolerance, and
/// faster where both are above 1 + tolerance: on another machine, or on one that is busy, what a
/// row is bound by may have changed by another factor than either figure of the machine.
std::vector<Change> changes(const Record& before, const Record& after, double tolerance);

std::string text_of(const std::vector<Change>& changes, double tolerance);
std::string markdown_of(const std::vector<Change>& changes, double tolerance);

/// An estimate with its confidence interval.
struct Interval {
  double value, lower, upper;
};

/// What a ratio typically is that was measured several times: the Hodges-Lehmann estimate of the
/// logarithms with the interval of Wilcoxon's signed-rank test at a confidence of 99.9 %, from its
/// normal approximation. Outliers hardly move it. Fewer than 15 ratios determine no interval; it
/// then has no bounds. There must be a ratio.
Interval typical_ratio(std::span<const double> ratios);

/// Slower where the whole interval is below 1 - tolerance, faster where it is above 1 + tolerance.
Verdict judge(const Interval& ratio, double tolerance);

/// "10%" or "0.1" as 0.1. Throws InputError, which names the option.
double share_of(const std::string& text, std::string_view option);

}  // namespace pliant::bench

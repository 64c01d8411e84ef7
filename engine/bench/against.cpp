#include "engine/bench/against.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>

#include "engine/bench/measured_program.hpp"

namespace pliant::bench {

namespace {

constexpr int least_pairs = 16;

/// Ratio of the speeds of two processes, from alternating turns. The order of each pair alternates
/// too, so that a machine that slows down favours neither.
double ratio_of(MeasuredProgram& own, MeasuredProgram& other) {
  using Clock = std::chrono::steady_clock;
  constexpr std::size_t least_turns = 6, most_turns = 40;
  constexpr std::chrono::seconds enough(1);
  std::vector<double> ratios;
  const auto start = Clock::now();
  while (ratios.size() < least_turns ||
         (ratios.size() < most_turns && Clock::now() - start < enough)) {
    const bool own_first = ratios.size() % 2 == 0;
    const double first = (own_first ? own : other).turn();
    const double second = (own_first ? other : own).turn();
    ratios.push_back(own_first ? first / second : second / first);
  }
  return typical_ratio(ratios).value;
}

/// Pairs of processes that measure one row.
class Pairs {
 public:
  Pairs(const AgainstOptions& options, std::string row) : options_(options), row_(std::move(row)) {}

  bool is_decided() const {
    const int pairs = count();
    if (pairs >= options_.most_pairs) return true;
    if (pairs < least_pairs) return false;
    const Interval ratio = typical_ratio(ratios_);
    return ratio.upper - ratio.lower < 2 * options_.width * ratio.value;
  }

  void measure() {
    MeasuredProgram own(options_.program, row_, options_.threads);
    MeasuredProgram other(options_.other, row_, options_.threads);
    ratios_.push_back(ratio_of(own, other));
    if (!options_.quiet) fmt::print(stderr, "{}, pair {}: {:.4f}\n", row_, count(), ratios_.back());
  }

  Against result() const {
    const Interval ratio = typical_ratio(ratios_);
    return {row_, count(), ratio, judge(ratio, options_.tolerance)};
  }

 private:
  int count() const { return static_cast<int>(ratios_.size()); }

  const AgainstOptions& options_;
  std::string row_;
  std::vector<double> ratios_;
};

}  // namespace

std::vector<Against> compare_programs(const AgainstOptions& options) {
  std::vector<Pairs> rows;
  rows.reserve(options.rows.size());
  for (const std::string& row : options.rows) rows.emplace_back(options, row);
  for (bool is_decided = false; !is_decided;) {
    is_decided = true;
    for (Pairs& row : rows) {
      if (row.is_decided()) continue;
      row.measure();
      is_decided = false;
    }
  }
  std::vector<Against> found;
  found.reserve(rows.size());
  for (const Pairs& row : rows) found.push_back(row.result());
  return found;
}

std::string text_of(const std::vector<Against>& found) {
  std::string text = fmt::format("{:<52}{:>7}{:>9}{:>20}  {}\n", "row", "pairs", "ratio",
                                 "99.9 % interval", "verdict");
  for (const Against& row : found) {
    text += fmt::format("{:<52}{:>7}{:>9.4f}{:>20}  {}\n", row.name, row.pairs, row.ratio.value,
                        fmt::format("{:.4f}..{:.4f}", row.ratio.lower, row.ratio.upper),
                        text_of(row.verdict));
  }
  return text + "Ratio: speed of this program over that of the other one.\n";
}

std::string markdown_of(const std::vector<Against>& found) {
  std::string text =
      "| row | pairs | ratio of speeds | 99.9 % interval | verdict |\n| --- | --- | --- | --- | "
      "--- |\n";
  for (const Against& row : found) {
    text += fmt::format("| {} | {} | {:.4f} | {:.4f} to {:.4f} | {} |\n", row.name, row.pairs,
                        row.ratio.value, row.ratio.lower, row.ratio.upper, text_of(row.verdict));
  }
  return text + "\nRatio: speed of this build over that of the other one, measured in turns.\n";
}

}  // namespace pliant::bench

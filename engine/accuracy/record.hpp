#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "engine/accuracy/reach.hpp"

namespace pliant::accuracy {

/// The errors that costs are given for.
inline constexpr std::array errors_of_interest = {0.03, 0.01, 0.003};

/// What the runs of one rung gave; all repetitions give the same answer.
struct RungRecord {
  std::vector<std::string> settings = {};  ///< of this rung, key=value
  std::int64_t particles = 0, steps = 0, peak_memory = 0;
  std::vector<double> seconds = {};            ///< wall time of the whole process, each repetition
  std::vector<double> processor_seconds = {};  ///< of all its threads, each repetition
  std::vector<std::pair<std::string, double>> values = {};  ///< of the targets
  double error = 0;                                         ///< of the worst target; NaN: none
  std::string message = {};                                 ///< why there is none

  double median_seconds() const;  ///< NaN where there is none
};

/// The results of one series, coarse rungs first.
struct SeriesRecord {
  std::string problem, series;
  std::vector<RungRecord> rungs = {};

  std::string name() const { return problem + "/" + series; }
  Cost cost_of(double error) const;
};

/// The results of all series, and the machine that they ran on.
struct AccuracyRecord {
  std::vector<std::string> machine;  ///< lines that describe it
  int threads = 1;
  std::vector<SeriesRecord> rows = {};
  bool interrupted = false;
};

/// The format that docs/plot_accuracy.py reads.
std::string json_of(const AccuracyRecord& record);

/// Two tables: what each error costs, and what each run gave.
std::string text_of(const AccuracyRecord& record);
std::string markdown_of(const AccuracyRecord& record);

}  // namespace pliant::accuracy

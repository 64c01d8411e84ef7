#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "engine/accuracy/reach.hpp"

namespace pliant::accuracy {

/// The errors for which costs are reported.
inline constexpr std::array errors_of_interest = {0.03, 0.01, 0.003};

/// The results of one rung; all repetitions have the same values.
struct RungRecord {
  std::vector<std::string> settings = {};  ///< of this rung, key=value
  std::int64_t particles = 0, steps = 0, peak_memory = 0;
  std::vector<double> seconds = {};            ///< wall time of the whole process, each repetition
  std::vector<double> processor_seconds = {};  ///< of all its threads, each repetition
  std::vector<std::pair<std::string, double>> values = {};  ///< of the targets
  double error = 0;                                         ///< of the worst target; NaN: no result
  std::string message = {};                                 ///< why there is no result

  double median_seconds() const;  ///< NaN without runs
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

/// Two tables: the cost of each error, and the results of each run.
std::string text_of(const AccuracyRecord& record);
std::string markdown_of(const AccuracyRecord& record);

}  // namespace pliant::accuracy

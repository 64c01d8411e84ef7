#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/bench/sample.hpp"

namespace pliant::bench {

using Figure = std::function<double(const Sample&)>;

struct Spread {
  double median, least, most;
};

/// All samples of one configuration of the standard set on a number of threads.
struct Row {
  Case settings;
  Window window;
  int threads;
  std::vector<Sample> samples;  ///< in the order of the repetitions

  /// Case, kernel, spacing and threads, such as rotating_cylinder/compact/0.03963/1.
  std::string name() const;
  /// Kernel, or precision if the method has no choice of kernels, as spelt in case files.
  std::string kernel() const;
  double flop() const;   ///< of a particle-stage
  double bytes() const;  ///< that a particle-stage reads and writes

  Spread spread(const Figure& figure) const;
  double median(const Figure& figure) const { return spread(figure).median; }

  double flop_rate(const Sample& sample) const;  ///< [flop/s]
  double byte_rate(const Sample& sample) const;  ///< [bytes/s]
  double fma_peak(const Sample& sample) const;   ///< in the precision of the row [flop/s]
  /// 1 - (seconds inside phases)/(threads x wall seconds).
  double idle_share(const Sample& sample) const;
};

/// Median over the repetitions of the rate relative to the same configuration on one thread; 0
/// without one.
double speed_up(const std::vector<Row>& rows, const Row& row, const Figure& rate);

/// Idle share of a row minus that of the largest body with the same case, kernel and threads.
double extra_idle_share(const std::vector<Row>& rows, const Row& row);

}  // namespace pliant::bench

#pragma once

#include <string>
#include <vector>

#include "engine/case/case.hpp"
#include "engine/output/archive/archive.hpp"

namespace pliant {

/// The values of all measurements over time, in memory: some kinds evaluate the history of another
/// measurement, and relative quantities need the value at the start.
class Histories {
 public:
  explicit Histories(const Case& settings)
      : settings_(&settings), rows_(settings.measurements.size()) {}

  /// Adds one row of raw values, and computes the values that depend on the past.
  void add(double time, std::vector<double> values);

  bool empty() const { return times_.empty(); }
  double last_time() const { return times_.back(); }
  /// Value of measurement `m` at the last time.
  double last(std::size_t m) const { return rows_[m].back(); }
  /// Why measurement `m` has no value at the last time; empty if it has one.
  std::string why_missing(std::size_t m) const;

  void put(ArchiveWriter& archive) const;
  void get(const ArchiveReader& archive);

 private:
  double weighted_sum(const MeasurementCase& m) const;

  const Case* settings_;
  std::vector<double> times_;
  std::vector<std::vector<double>> rows_;  ///< [measurement][time]
  std::vector<double> start_;              ///< raw values at the start
  std::vector<double> latest_;             ///< raw values at the last time: forces are differences
};

}  // namespace pliant

#pragma once

#include <string>
#include <vector>

#include "engine/case/case.hpp"
#include "engine/output/archive.hpp"

namespace pliant {

/// Values of every measurement over time, in memory: relative quantities and oscillations read
/// their own past.
class Histories {
 public:
  explicit Histories(const Case& settings)
      : settings_(&settings), rows_(settings.measurements.size()) {}

  /// Takes one row of raw values; completes those that depend on the past.
  void add(double time, std::vector<double> values);

  bool empty() const { return times_.empty(); }
  double last_time() const { return times_.back(); }
  /// Of measurement `m`, at the last time.
  double last(std::size_t m) const { return rows_[m].back(); }

  void put(ArchiveWriter& archive) const;
  void get(const ArchiveReader& archive);

 private:
  const Case* settings_;
  std::vector<double> times_;
  std::vector<std::vector<double>> rows_;  ///< [measurement][time]
  std::vector<double> start_;              ///< raw values at the start
  std::vector<double> latest_;             ///< raw values at the last time: forces are differences
};

/// SI unit of a measurement's values, "1" for ratios.
std::string unit_of(const Case& settings, const MeasurementCase& m);

}  // namespace pliant

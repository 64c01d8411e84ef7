#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "engine/output/hdf5/hdf5.hpp"

namespace pliant {

/// Measurements over time: /measurements/NAME/time and .../value, attribute unit. Rows are held
/// back until `flush`. Throws hdf5::Failure.
class HistoryStore {
 public:
  /// Opens the histories in the file, if any.
  explicit HistoryStore(hid_t file);

  void append(const std::string& name, const std::string& unit, double time, double value);
  void flush();

  /// Cuts every history to its number of rows in `rows`, and removes histories that are not in
  /// `rows`.
  void truncate(const std::map<std::string, std::int64_t>& rows);
  std::map<std::string, std::int64_t> rows() const;  ///< including those held back

 private:
  struct History {
    std::string unit;
    std::vector<double> time, value;  ///< held back
    hdf5::GrowingArray stored_time, stored_value;
    std::int64_t stored = 0;
  };
  void create(const std::string& name, History& history);

  hdf5::Handle group_;
  std::map<std::string, History> histories_;
};

}  // namespace pliant

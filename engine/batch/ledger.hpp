#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/batch/database.hpp"
#include "engine/batch/designs.hpp"

namespace pliant::batch {

enum class RunStatus { pending, running, done, failed };

std::string_view word_of(RunStatus status);
RunStatus status_of(std::string_view word);  ///< pending for any other word

/// [s since 1970]
double now();

/// What a run left when it ended, from its process and its summary.json.
struct Outcome {
  std::optional<std::int64_t> exit_status;  ///< 128 + signal where one ended it; none: not started
  std::string message = {};                 ///< why it failed
  double wall_seconds = 0, processor_seconds = 0;
  std::int64_t peak_memory = 0;  ///< [bytes]
  struct Measurement {
    std::string name, unit;
    double value;  ///< NaN: none
  };
  std::vector<Measurement> measurements = {};
  std::vector<std::pair<std::string, std::string>> versions = {};  ///< program and libraries
  std::int64_t particles = 0, steps = 0;  ///< of its summary, not kept in the ledger
};

/// A run of a batch, as its ledger knows it.
struct RunRow {
  std::string name;
  RunStatus status = RunStatus::pending;
  std::int64_t attempts = 0;
  double started = 0, ended = 0;  ///< of the last attempt [s since 1970]; NaN: not yet
  Assignment parameters;
  Outcome outcome;
};

/// What is known of all runs of a batch, in `batch.sqlite` of its folder. Each change is one
/// transaction, so that it survives the end of the process at any moment.
class Ledger {
 public:
  enum class Use { write, read };

  static bool exists(const std::filesystem::path& folder);
  /// Makes a ledger for writing where there is none. Throws OutputError.
  Ledger(const std::filesystem::path& folder, Use use);

  /// Facts about the whole batch.
  void set(std::string_view key, std::string_view value);
  std::optional<std::string> get(std::string_view key);

  /// Adds the runs that it does not hold yet, all or none.
  void add(const std::vector<Assignment>& runs);
  /// Runs that were at work when the program was killed are pending again.
  void reset_running();
  void start(const std::string& run);
  void end(const std::string& run, RunStatus status, const Outcome& outcome);
  /// All that a row says of its last attempt, where another process has made it.
  void put(const RunRow& row);

  /// All runs, in the order in which they were added.
  std::vector<RunRow> rows();

 private:
  void put_end(const std::string& run, RunStatus status, double ended, const Outcome& outcome);
  void put_details(const std::string& run, const Outcome& outcome);
  void get_details(std::map<std::string, RunRow*>& by_name);

  Database database_;
};

}  // namespace pliant::batch

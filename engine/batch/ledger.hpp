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

/// The result of a run that has ended, from its process and its summary.json.
struct Outcome {
  std::optional<std::int64_t>
      exit_status;           ///< 128 + signal if a signal ended it; none: not started
  std::string message = {};  ///< why it failed
  double wall_seconds = 0, processor_seconds = 0;
  std::int64_t peak_memory = 0;  ///< [B]
  struct Measurement {
    std::string name, unit;
    double value;  ///< NaN: none
  };
  std::vector<Measurement> measurements = {};
  std::vector<std::pair<std::string, std::string>> versions = {};  ///< program and libraries
  std::int64_t particles = 0, steps = 0;  ///< from its summary; not in the ledger
};

struct RunRow {
  std::string name;
  RunStatus status = RunStatus::pending;
  std::int64_t attempts = 0;
  double started = 0, ended = 0;  ///< of the last attempt [s since 1970]; NaN: not yet
  Assignment parameters;
  Outcome outcome;
};

/// The state of all runs of a batch, in `batch.sqlite` of its folder. Each change is one
/// transaction, so that it survives if the process ends at any time.
class Ledger {
 public:
  enum class Use { write, read };

  static bool exists(const std::filesystem::path& folder);
  /// For writing, creates the ledger if it does not exist. Throws OutputError.
  Ledger(const std::filesystem::path& folder, Use use);

  /// Values that concern the whole batch.
  void set(std::string_view key, std::string_view value);
  std::optional<std::string> get(std::string_view key);

  /// Adds the runs that are not in the ledger yet, all or none.
  void add(const std::vector<Assignment>& runs);
  /// Sets runs to pending that were running when the program was killed.
  void reset_running();
  void start(const std::string& run);
  void end(const std::string& run, RunStatus status, const Outcome& outcome);
  /// Writes a row about the last attempt, made by another process.
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

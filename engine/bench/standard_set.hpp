#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/bench/record.hpp"

namespace pliant::bench {

struct StandardSetOptions {
  bool quick = false;                   ///< fewer repetitions, no more than 131 072 particles
  std::optional<std::int64_t> ball;     ///< nothing but balls of so many particles
  std::optional<std::int64_t> largest;  ///< the growth table up to so many particles instead
  std::optional<std::filesystem::path> csv, growth_markdown;
  int threads = 2;                 ///< compared with one thread
  std::string rows;                ///< only those whose name contains it
  std::optional<int> repetitions;  ///< default: 5, of the quick set 3
  bool tables = true;              ///< print them to stdout
};

/// Measures the machine, then the standard set: cases x kernels x {1, threads} threads, in turns,
/// several times. Prints tables to stdout and progress to stderr. Throws OutputError, and
/// InputError where no row has the name.
Record run_standard_set(const StandardSetOptions& options);

/// The rows that it measures, without samples. Throws InputError where no row has the name.
std::vector<Row> standard_set(const StandardSetOptions& options);

/// Their names.
std::vector<std::string> names_of_rows(const StandardSetOptions& options);

}  // namespace pliant::bench

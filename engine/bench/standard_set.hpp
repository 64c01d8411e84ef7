#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/bench/record.hpp"

namespace pliant::bench {

struct StandardSetOptions {
  bool quick = false;                   ///< fewer repetitions, no more than 131 072 particles
  std::optional<std::int64_t> ball;     ///< only balls with so many particles
  std::optional<std::int64_t> largest;  ///< instead a growth table up to so many particles
  std::optional<std::filesystem::path> csv, growth_markdown;
  int threads = 2;                 ///< compared to one thread
  std::string rows;                ///< only rows whose name contains it
  std::optional<int> repetitions;  ///< default: 5, of the quick set 3
  bool tables = true;              ///< print them to stdout
};

/// Measures the machine, then the standard set: cases x kernels x {1, threads} threads, in turns,
/// several times. Prints tables to stdout and progress to stderr. Throws OutputError, and
/// InputError if no row has the name.
Record run_standard_set(const StandardSetOptions& options);

/// The rows of the standard set, without samples. Throws InputError if no row has the name.
std::vector<Row> standard_set(const StandardSetOptions& options);

std::vector<std::string> names_of_rows(const StandardSetOptions& options);

}  // namespace pliant::bench

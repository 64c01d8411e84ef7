#pragma once

#include <filesystem>
#include <optional>

namespace pliant::bench {

struct StandardSetOptions {
  bool quick = false;                ///< fewer repetitions, no more than 131 072 particles
  std::optional<std::int64_t> ball;  ///< nothing but balls of so many particles
  std::optional<std::filesystem::path> csv;
  int threads = 2;  ///< compared with one thread
};

/// Measures the machine, then the standard set: cases x weights x {1, threads} threads, in turns,
/// several times. Prints tables to stdout and progress to stderr. Throws OutputError.
void run_standard_set(const StandardSetOptions& options);

}  // namespace pliant::bench

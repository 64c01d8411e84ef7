#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/bench/comparison.hpp"

namespace pliant::bench {

struct AgainstOptions {
  std::filesystem::path other;                       ///< the program to compare with
  std::filesystem::path program = "/proc/self/exe";  ///< this one
  std::vector<std::string> rows;                     ///< names
  int threads = 0;
  double tolerance = 0.01;
  double width = 0.01;  ///< pairs are added until the interval is this narrow
  int most_pairs = 200;
  bool quiet = false;
};

/// Ratio of the speed of this program to that of the other one.
struct Against {
  std::string name;
  int pairs = 0;
  Interval ratio;
  Verdict verdict = Verdict::same;
};

/// Starts pairs of processes, one of each program, which measure a row in alternating turns until
/// the ratio of their speeds is known. Many pairs, since the placement of a process in memory
/// affects its speed by some percent; short turns, since other programs start and end within
/// seconds. Throws InputError if the other program cannot be run or does not know the row.
std::vector<Against> compare_programs(const AgainstOptions& options);

std::string text_of(const std::vector<Against>& found);
std::string markdown_of(const std::vector<Against>& found);

}  // namespace pliant::bench

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/bench/comparison.hpp"

namespace pliant::bench {

/// How two programs are compared.
struct AgainstOptions {
  std::filesystem::path other;                       ///< the program to compare with
  std::filesystem::path program = "/proc/self/exe";  ///< this one
  std::vector<std::string> rows;                     ///< names
  int threads = 0;
  double tolerance = 0.01;
  double width = 0.01;  ///< pairs follow until the interval reaches no further than this
  int most_pairs = 200;
  bool quiet = false;
};

/// Speed of this program over that of the other one.
struct Against {
  std::string name;
  int pairs = 0;
  Interval ratio;
  Verdict verdict = Verdict::same;
};

/// Starts pairs of processes, one of each program, which measure a row in short turns, one waiting
/// for the other, until the ratio of their speeds is known. Where the pages of a process lie in
/// memory decides some per cent of its speed: hence many pairs. Other programs come and go within
/// seconds: hence short turns. Throws InputError where the other one cannot be run or does not know
/// the row.
std::vector<Against> compare_programs(const AgainstOptions& options);

std::string text_of(const std::vector<Against>& found);
std::string markdown_of(const std::vector<Against>& found);

}  // namespace pliant::bench

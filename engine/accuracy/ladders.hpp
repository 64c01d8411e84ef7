#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// Time to a given error: problems with known solutions, run over ladders of spacings.
namespace pliant::accuracy {

/// Settings of one run beyond those of its problem and series, key=value.
using Rung = std::vector<std::string>;

/// A measurement at the end of a run with a known value.
struct Target {
  std::string measurement;
  double reference = 0;
  double scale = 1;  ///< deviations are divided by it
};

/// A method, kernel or precision for the problem, from coarse to fine.
struct Series {
  std::string name;
  std::vector<std::string> settings = {};  ///< key=value
  std::vector<Rung> rungs = {};
  int quick_rungs = 0;  ///< number of rungs with --quick
};

/// A case with known results, and the series of runs for it.
struct Problem {
  std::string name;
  std::filesystem::path case_file;
  std::vector<std::string> settings = {};  ///< of all its runs
  std::vector<Target> targets = {};        ///< the largest of their errors counts
  std::vector<Series> series = {};
};

/// A file of problems.
struct Ladders {
  double time_limit = 0;  ///< of a run [s]; 0: none
  std::vector<Problem> problems = {};
};

/// Throws InputError that names file, line and remedy.
Ladders read_ladders(const std::filesystem::path& file);

/// Only the series whose name, such as compression/compact, contains the text; with `quick`, only
/// their quick rungs. Throws InputError if nothing is left.
Ladders selected(const Ladders& ladders, const std::string& rows, bool quick);

}  // namespace pliant::accuracy

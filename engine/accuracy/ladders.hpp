#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// Time to a given error: problems with known answers, run over ladders of spacings.
namespace pliant::accuracy {

/// Settings of one run beyond those of its problem and series, key=value.
using Rung = std::vector<std::string>;

/// A measurement at the end of a run whose right value is known.
struct Target {
  std::string measurement;
  double reference = 0;
  double scale = 1;  ///< what deviations are divided by
};

/// A method, kernel or precision that solves the problem, from coarse to fine.
struct Series {
  std::string name;
  std::vector<std::string> settings = {};  ///< key=value
  std::vector<Rung> rungs = {};
  int quick_rungs = 0;  ///< so many of them with --quick
};

/// A case with known answers, and the series of runs that solve it.
struct Problem {
  std::string name;
  std::filesystem::path case_file;
  std::vector<std::string> settings = {};  ///< of all its runs
  std::vector<Target> targets = {};        ///< the error is that of the worst
  std::vector<Series> series = {};
};

/// A file of problems.
struct Ladders {
  double time_limit = 0;  ///< of a run [s]; 0: none
  std::vector<Problem> problems = {};
};

/// Throws InputError, which names file, line and remedy.
Ladders read_ladders(const std::filesystem::path& file);

/// Only the series whose name, as in compression/compact, contains the text; with `quick` the
/// rungs that it takes. Throws InputError where nothing is left.
Ladders selected(const Ladders& ladders, const std::string& rows, bool quick);

}  // namespace pliant::accuracy

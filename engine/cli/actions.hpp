#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/case/case.hpp"
#include "engine/cli/exit_status.hpp"

/// The actions of the program's commands. They throw InputError for user errors.
namespace pliant::cli {

/// A case and the settings that override its keys.
struct CaseArguments {
  std::filesystem::path path;         ///< a case file or its folder
  std::vector<std::string> settings;  ///< key=value
};

struct RunArguments {
  CaseArguments source;
  std::optional<std::filesystem::path> folder;  ///< default: results/<case>
  int threads = 0;                              ///< 0: one per processor
  std::string isa;                              ///< empty: the widest supported
  bool resume = false;
  bool force = false;  ///< run even if memory may not suffice
  bool quiet = false;
  bool report = false;  ///< write a page at the end
};

ExitStatus run(const RunArguments& arguments);

/// The warnings of `run` and `check` for a case of any method, one sentence each.
std::vector<std::string> warnings_of(const Case& settings);

struct CheckArguments {
  CaseArguments source;
  bool json = false;
};

/// Prints what a case would run.
ExitStatus check(const CheckArguments& arguments);

struct ListArguments {
  std::filesystem::path folder = "cases";
  bool json = false;
};

/// Lists the cases below a folder, with their titles.
ExitStatus list(const ListArguments& arguments);

struct GraphArguments {
  CaseArguments source;
  std::string format = "dot";  ///< dot or json
  bool blocks = false;         ///< a node for each phase and block, not for each phase
};

ExitStatus graph(const GraphArguments& arguments);

struct BenchArguments {
  bool quick = false;
  std::optional<std::int64_t> ball;
  std::optional<std::filesystem::path> csv;
  int threads = 0;  ///< as in RunArguments
  std::string rows;
  std::optional<int> repetitions;
  std::optional<std::filesystem::path> save, compare, against, markdown;
  std::string tolerance;  ///< empty: the default
  bool turns = false;     ///< answer a comparing program
  bool json = false;
  bool accuracy = false;  ///< time to a given error; uses the next four
  bool resume = false;
  std::optional<std::filesystem::path> ladders, folder;
  std::optional<double> time_limit;    ///< of a run [s]
  std::optional<std::int64_t> growth;  ///< a growth table up to so many particles
};

/// Measures the machine and the standard set of cases.
ExitStatus bench(const BenchArguments& arguments);

struct ProfileArguments {
  CaseArguments source;
  std::string budget, frame_time;  ///< with units; empty: the defaults
  std::optional<int> frames, warm_up;
  double percentile = 99;
  int threads = 0;  ///< see RunArguments, also for `isa`
  std::string isa;
  std::filesystem::path trace, report;  ///< empty: none
  bool fit = false, json = false, quiet = false;
};

/// Measures whether a case meets a budget of wall time for each frame of simulated time.
ExitStatus profile(const ProfileArguments& arguments);

struct NoArguments {};

/// Prints the reference of case files, docs/case-reference.md.
ExitStatus reference(const NoArguments&);

ExitStatus schema(const NoArguments&);

}  // namespace pliant::cli

#include "engine/cli/verbs.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <memory>
#include <system_error>

#include "engine/batch/child.hpp"
#include "engine/bench/standard_set.hpp"
#include "engine/case/reference.hpp"
#include "engine/case/stability.hpp"
#include "engine/case/validate_summary.hpp"
#include "engine/simulation/estimate.hpp"
#include "engine/simulation/methods.hpp"
#include "engine/simulation/run.hpp"
#include "engine/simulation/solver_options.hpp"

namespace pliant::cli {

namespace {

void warn_of_instability(const Case& settings) {
  const std::string warning = stability_warning(settings);
  // A stderr that cannot be written must not end the run.
  if (!warning.empty()) std::fputs(fmt::format("warning: {}\n", warning).c_str(), stderr);
}

}  // namespace

ExitStatus run(const RunArguments& arguments) {
  // A reader of the progress that ends, as `head` does, must not end the run.
  std::signal(SIGPIPE, SIG_IGN);
  batch::end_with_parent();
  const Case settings = read_case(arguments.source.path, arguments.source.settings);
  if (!arguments.quiet) warn_of_instability(settings);
  if (!arguments.force) {
    refuse_what_does_not_fit(settings, estimate(settings), available_memory());
  }
  RunOptions options;
  options.folder = arguments.folder.value_or(std::filesystem::path("results") / settings.name);
  const SolverOptions machine = solver_options(arguments.threads, arguments.isa);
  options.threads = machine.threads;
  options.isa = machine.isa;
  options.resume = arguments.resume;
  options.quiet = arguments.quiet;
  return run_case(settings, options) == RunEnd::done ? ExitStatus::done : ExitStatus::interrupted;
}

ExitStatus check(const CaseArguments& arguments) {
  const Case settings = read_case(arguments.path, arguments.settings);
  warn_of_instability(settings);
  fmt::print("{}", validate_summary(settings));
  const Estimate size = estimate(settings);
  fmt::print("  cost: {}", size.text());
  const SolverOptions machine = solver_options(0, "");
  const std::optional<double> seconds = estimated_seconds(settings, size, machine, methods());
  if (seconds) {
    fmt::print(", {} on {} threads (within a factor of two)", duration_text(*seconds),
               machine.threads);
  }
  fmt::print("\n");
  return ExitStatus::done;
}

ExitStatus list(const std::filesystem::path& folder) {
  std::error_code error;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    std::error_code unreadable;
    const auto file = entry.path() / "case.toml";
    if (std::filesystem::exists(file, unreadable)) files.push_back(file);
  }
  if (error) {
    throw InputError(fmt::format("{}: cannot be listed: {}; give a folder that holds cases",
                                 folder.string(), error.message()));
  }
  std::sort(files.begin(), files.end());
  for (const auto& file : files) fmt::print("{:40} {}\n", file.string(), read_case(file).title);
  return ExitStatus::done;
}

ExitStatus graph(const GraphArguments& arguments) {
  const Case settings = read_case(arguments.source.path, arguments.source.settings);
  const std::unique_ptr<Solver> solver = methods().make(settings, {});
  const scheduler::StepGraph& graph = solver->step_graph();
  const auto detail = arguments.blocks ? scheduler::Detail::blocks : scheduler::Detail::phases;
  fmt::print("{}", arguments.format == "json" ? graph.json() : graph.dot(detail));
  return ExitStatus::done;
}

ExitStatus bench(const BenchArguments& arguments) {
  bench::run_standard_set({arguments.quick, arguments.ball, arguments.csv,
                           solver_options(arguments.threads, "").threads});
  return ExitStatus::done;
}

ExitStatus reference(const NoArguments&) {
  fmt::print("{}", case_reference_markdown(methods().rules()));
  return ExitStatus::done;
}

}  // namespace pliant::cli

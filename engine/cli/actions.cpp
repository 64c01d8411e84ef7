#include "engine/cli/actions.hpp"

#include <fmt/format.h>
#include <unistd.h>
#include <pliant/error.hpp>

#include <csignal>
#include <cstdio>
#include <memory>
#include <optional>

#include "engine/batch/child.hpp"
#include "engine/case/checks/stability.hpp"
#include "engine/case/placement.hpp"
#include "engine/case/vocabulary/measurement_kinds.hpp"
#include "engine/case/writing/reference.hpp"
#include "engine/case/writing/schema.hpp"
#include "engine/cli/report.hpp"
#include "engine/cli/setup_progress.hpp"
#include "engine/output/colour.hpp"
#include "engine/output/interrupt.hpp"
#include "engine/simulation/estimate.hpp"
#include "engine/simulation/methods.hpp"
#include "engine/simulation/run.hpp"
#include "engine/simulation/solver_options.hpp"

namespace pliant::cli {

namespace {

/// An stderr that cannot be written must not end the run.
void warn_of(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) {
    const std::string text =
        fmt::format("{} {}\n", coloured("warning:", Colour::yellow, stderr), warning);
    std::fputs(text.c_str(), stderr);
  }
}

/// Set-up may take long, so it is announced to the user.
void announce(const Case& settings, const Estimate& size, const SolverOptions& machine) {
  if (::isatty(STDERR_FILENO) == 0) return;
  const std::string text = fmt::format("{}: setting up {}; {} threads, {}\n", settings.name,
                                       size.text(), machine.threads, kernels::name(machine.isa));
  std::fputs(text.c_str(), stderr);
}

}  // namespace

std::vector<std::string> warnings_of(const Case& settings) {
  std::vector<std::string> warnings = placement_warnings(settings);
  const std::string of_steps = stability_warning(settings);
  if (!of_steps.empty()) warnings.insert(warnings.begin(), of_steps);
  return warnings;
}

ExitStatus run(const RunArguments& arguments) {
  // If a reader of the progress ends, such as `head`, the run must not end.
  std::signal(SIGPIPE, SIG_IGN);
  batch::end_with_parent();
  const ExitOnInterrupt in_set_up(static_cast<int>(ExitStatus::interrupted),
                                  "interrupted before the first step; run it again\n");
  const Case settings = read_case(arguments.source.path, arguments.source.settings);
  warn_of(warnings_of(settings));
  const Estimate size = estimate(settings);
  if (!arguments.force) refuse_what_does_not_fit(settings, size, available_memory());
  RunOptions options;
  options.folder = arguments.folder.value_or(std::filesystem::path("results") / settings.name);
  const SolverOptions machine = solver_options(arguments.threads, arguments.isa);
  options.threads = machine.threads;
  options.isa = machine.isa;
  options.resume = arguments.resume;
  options.quiet = arguments.quiet;
  std::optional<SetupProgress> progress;
  if (!arguments.quiet) {
    announce(settings, size, machine);
    progress.emplace(size.bytes);
    options.when_set_up = [&] { progress->finish(); };
  }
  if (run_case(settings, options) != RunEnd::done) return ExitStatus::interrupted;
  if (!arguments.report) return ExitStatus::done;
  ReportArguments page;
  page.folder = options.folder;
  return report(page);
}

ExitStatus graph(const GraphArguments& arguments) {
  const Case settings = read_case(arguments.source.path, arguments.source.settings);
  const std::unique_ptr<Solver> solver = methods().make(settings, {});
  const scheduler::StepGraph& graph = solver->step_graph();
  const auto detail = arguments.blocks ? scheduler::Detail::blocks : scheduler::Detail::phases;
  fmt::print("{}", arguments.format == "json" ? graph.json() : graph.dot(detail));
  return ExitStatus::done;
}

ExitStatus reference(const NoArguments&) {
  fmt::print("{}", case_reference_markdown(methods().rules()));
  return ExitStatus::done;
}

ExitStatus schema(const NoArguments&) {
  fmt::print("{}", case_schema_json(methods().rules()));
  return ExitStatus::done;
}

}  // namespace pliant::cli

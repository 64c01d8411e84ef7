#include <fmt/format.h>
#include <unistd.h>
#include <pliant/error.hpp>

#include <cstdio>
#include <optional>

#include "engine/case/checks/stability.hpp"
#include "engine/cli/actions.hpp"
#include "engine/method/step_failure.hpp"
#include "engine/output/atomic_file.hpp"
#include "engine/profile/duration.hpp"
#include "engine/profile/fit.hpp"
#include "engine/profile/profile.hpp"
#include "engine/profile/report.hpp"
#include "engine/simulation/estimate.hpp"
#include "engine/simulation/methods.hpp"
#include "engine/simulation/solver_options.hpp"

namespace pliant::cli {

namespace {

profile::ProfileOptions options_of(const ProfileArguments& arguments) {
  profile::ProfileOptions options;
  if (!arguments.frame_time.empty()) {
    options.frame_seconds = profile::seconds_of(arguments.frame_time, "--frame-time");
  }
  options.budget = arguments.budget.empty() ? options.frame_seconds
                                            : profile::seconds_of(arguments.budget, "--budget");
  options.percentile = arguments.percentile;
  options.frames = arguments.frames;
  options.warm_up = arguments.warm_up;
  options.machine = solver_options(arguments.threads, arguments.isa);
  options.trace = arguments.trace;
  return options;
}

/// Redraws the number of frames on a terminal.
profile::OnFrame progress(const ProfileArguments& arguments) {
  if (arguments.quiet || ::isatty(STDERR_FILENO) == 0) return {};
  return [](int done, int all) {
    std::fputs(fmt::format("\rframe {} of {}{}", done, all, done == all ? "\r\x1b[K" : "").c_str(),
               stderr);
  };
}

void write(const ProfileArguments& arguments, const std::string& text, const std::string& json) {
  fmt::print("{}", arguments.json ? json : text);
  if (!arguments.report.empty()) write_atomically(arguments.report, json, Durable::no);
}

/// The case with a spacing, as from the command line, so that all checks of cases apply.
Case with_spacing(const ProfileArguments& arguments, double spacing) {
  std::vector<std::string> settings = arguments.source.settings;
  settings.push_back(fmt::format("discretisation.spacing={}", spacing));
  return read_case(arguments.source.path, settings);
}

/// None if interrupted.
std::optional<profile::FitTry> try_spacing(const ProfileArguments& arguments,
                                           profile::ProfileOptions options, double spacing) {
  const Case settings = with_spacing(arguments, spacing);
  profile::FitTry found;
  found.spacing = spacing;
  found.problem = stability_warning(settings);
  if (!found.problem.empty()) return found;
  refuse_what_does_not_fit(settings, estimate(settings), available_memory());
  options.stop_when_missed = true;
  const profile::Profile result = run_profile(settings, options, methods(), progress(arguments));
  if (result.interrupted) return std::nullopt;
  const profile::Verdict verdict = judge(result);
  found.particles = result.particles;
  found.seconds = verdict.at_percentile;
  found.held = verdict.held;
  return found;
}

void show(const profile::FitTry& found) {
  const std::string result = !found.problem.empty() ? found.problem
                             : found.held           ? "held"
                                                    : "missed";
  std::fputs(fmt::format("spacing {:.6g} m: {}\n", found.spacing, result).c_str(), stderr);
}

// The spacing of the case must work. Others may fail: too coarse for a body, or too fine for
// memory.
ExitStatus fit(const ProfileArguments& arguments, const profile::ProfileOptions& options) {
  const Case settings = read_case(arguments.source.path, arguments.source.settings);
  bool is_first = true, is_interrupted = false;
  const auto one = [&](double spacing) {
    const double fitting = profile::fitting_spacing(settings, spacing);
    std::optional<profile::FitTry> found;
    try {
      found = try_spacing(arguments, options, fitting);
    } catch (const StepFailure& failure) {
      if (is_first) throw;
      found = {fitting, 0, 0, false, failure.what()};
    } catch (const InputError& error) {
      if (is_first) throw;
      found = {fitting, 0, 0, false, error.what()};
    }
    is_first = false;
    is_interrupted = !found;
    if (found && !arguments.quiet) show(*found);
    return found;
  };
  const profile::Fit result = profile::fit_spacing(settings.discretisation.spacing, options.budget,
                                                   settings.dimension, one);
  write(arguments, text_of(result, options), json_of(result, options));
  if (is_interrupted) return ExitStatus::interrupted;
  return result.best >= 0 ? ExitStatus::done : ExitStatus::missed;
}

}  // namespace

ExitStatus profile(const ProfileArguments& arguments) {
  const profile::ProfileOptions options = options_of(arguments);
  if (arguments.fit) {
    if (!arguments.trace.empty()) {
      throw InputError("--trace: not with --fit, which runs the case many times; take one of them");
    }
    return fit(arguments, options);
  }
  const Case settings = read_case(arguments.source.path, arguments.source.settings);
  const profile::Profile result = run_profile(settings, options, methods(), progress(arguments));
  if (result.frames.empty()) return ExitStatus::interrupted;
  const profile::Verdict verdict = judge(result);
  write(arguments, text_of(result, verdict), json_of(result, verdict));
  if (result.interrupted) return ExitStatus::interrupted;
  return verdict.held ? ExitStatus::done : ExitStatus::missed;
}

}  // namespace pliant::cli

#include "engine/cli/calibrate.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <algorithm>
#include <csignal>

#include "engine/calibrate/report.hpp"
#include "engine/calibrate/runs.hpp"
#include "engine/output/atomic_file.hpp"
#include "engine/simulation/methods.hpp"

namespace pliant::cli {

namespace {

/// Reports a wrong key or name at once, before the first run.
void check_case(const calibrate::Fit& fit) {
  std::vector<std::string> settings = fit.settings;
  for (const calibrate::Parameter& parameter : fit.parameters) {
    settings.push_back(fmt::format("{}={}", parameter.key, parameter.start));
  }
  const Case a_case = read_case(fit.case_file, settings);
  for (const calibrate::Curve& curve : fit.curves) {
    const bool known = std::ranges::any_of(a_case.measurements, [&](const MeasurementCase& one) {
      return one.name == curve.measurement;
    });
    if (!known) {
      throw InputError(fmt::format("{}: has no measurement `{}`; name one that it has",
                                   fit.case_file.string(), curve.measurement));
    }
    if (std::ranges::max(curve.time) > a_case.time.end * (1 + 1e-12) ||
        std::ranges::min(curve.time) < 0) {
      throw InputError(fmt::format(
          "the curve of `{}` has values outside the run, from 0 to {} s; set time.end, or leave "
          "them out",
          curve.measurement, a_case.time.end));
    }
  }
}

}  // namespace

ExitStatus calibrate(const CalibrateArguments& arguments) {
  std::signal(SIGPIPE, SIG_IGN);
  const calibrate::Fit fit = calibrate::read_fit(arguments.fit);
  check_case(fit);
  const batch::BatchOptions options = options_of(arguments, fit.name);
  try {
    calibrate::Runs runs(fit, options);
    const calibrate::Calibration found = calibrate::optimise(
        fit.parameters, [&](const auto& points) { return runs(points); }, fit.optimiser);
    write_atomically(options.folder / "fit.json", json_of(fit, found), Durable::no);
    write_atomically(options.folder / "curves.csv", curves_csv(fit, found), Durable::no);
    fmt::print("{}", arguments.json ? json_of(fit, found) : text_of(fit, found));
    return found.has_converged ? ExitStatus::done : ExitStatus::missed;
  } catch (const calibrate::Interrupted&) {
    return ExitStatus::interrupted;
  }
}

}  // namespace pliant::cli

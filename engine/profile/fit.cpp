#include "engine/profile/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/profile/report.hpp"

namespace pliant::profile {

namespace {

constexpr double close_enough = 1.03;
constexpr int most_tries = 24;
// Largest factor between two guesses; a wrong law of cost could lead far away.
constexpr double longest_stride = 2.5;

}  // namespace

Fit fit_spacing(double spacing, double budget, int dimension, const TrySpacing& try_spacing) {
  Fit fit;
  double held = 0, missed = 0;  // spacings; 0: none yet
  double next = spacing;
  while (static_cast<int>(fit.tries.size()) < most_tries) {
    const std::optional<FitTry> answer = try_spacing(next);
    if (!answer) break;
    const FitTry& found = *answer;
    fit.tries.push_back(found);
    const double h = found.spacing;
    if (found.held && (held == 0 || h < held)) {
      held = h;
      fit.best = static_cast<int>(fit.tries.size()) - 1;
    }
    if (!found.held) missed = std::max(missed, h);
    if (held > 0 && missed > 0) {
      if (held <= missed * close_enough) break;
      next = std::sqrt(held * missed);
    } else if (!found.problem.empty()) {
      break;  // the case cannot run at all, or not with such a coarse spacing
    } else {
      // Goes beyond the law of cost, so that the next try closes the bracket.
      const double law = std::pow(found.seconds / budget, 1.0 / (dimension + 1));
      const double margin = found.held ? 1 / 1.1 : 1.1;
      next = h * std::clamp(law * margin, 1 / longest_stride, longest_stride);
    }
    const bool repeats = std::any_of(fit.tries.begin(), fit.tries.end(), [&](const FitTry& one) {
      return std::abs(one.spacing / next - 1) < 1e-9;
    });
    if (repeats) break;
  }
  return fit;
}

double fitting_spacing(const Case& settings, double spacing) {
  double period = 0;
  for (int axis = 0; axis < settings.dimension; ++axis) {
    if (!settings.periodic.axis[static_cast<std::size_t>(axis)]) continue;
    const auto a = static_cast<std::size_t>(axis);
    const double length = settings.periodic.upper[a] - settings.periodic.lower[a];
    if (period == 0 || length < period) period = length;
  }
  return period == 0 ? spacing : period / std::max(1.0, std::round(period / spacing));
}

std::string text_of(const Fit& fit, const ProfileOptions& options) {
  std::string text = fmt::format("{:>14} {:>11} {:>16}\n", "spacing [m]", "particles",
                                 fmt::format("p{:g} [ms]", options.percentile));
  for (const FitTry& one : fit.tries) {
    text += one.problem.empty()
                ? fmt::format("{:>14.6g} {:>11} {:>16.4g}  {}\n", one.spacing, one.particles,
                              1e3 * one.seconds, one.held ? "held" : "missed")
                : fmt::format("{:>14.6g} {:>11} {:>16}  {}\n", one.spacing, "-", "-", one.problem);
  }
  if (fit.best < 0) return text + "no spacing holds the budget\n";
  const FitTry& best = fit.tries[static_cast<std::size_t>(fit.best)];
  return text + fmt::format(
                    "the budget of {} is held at p{:g} with up to {} particles: "
                    "--set discretisation.spacing={:.6g}\n",
                    short_time(options.budget), options.percentile, best.particles, best.spacing);
}

std::string json_of(const Fit& fit, const ProfileOptions& options) {
  using Json = nlohmann::ordered_json;
  Json tries = Json::array();
  for (const FitTry& one : fit.tries) {
    Json row = {{"spacing", one.spacing},
                {"particles", one.particles},
                {"seconds_at_percentile", one.seconds},
                {"held", one.held}};
    if (!one.problem.empty()) row["problem"] = one.problem;
    tries.push_back(row);
  }
  Json report = {{"budget", options.budget},
                 {"percentile", options.percentile},
                 {"threads", options.machine.threads},
                 {"held", fit.best >= 0},
                 {"tries", tries}};
  if (fit.best >= 0) report["best"] = tries[static_cast<std::size_t>(fit.best)];
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace pliant::profile

#include "engine/calibrate/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/batch/csv.hpp"

namespace pliant::calibrate {

namespace {

std::string_view text_of(Determination determination) {
  switch (determination) {
    case Determination::well:
      return "well determined";
    case Determination::poorly:
      return "poorly determined";
    case Determination::not_at_all:
      break;
  }
  return "not determined by these data";
}

double root_mean_square(const Residuals& residuals) {
  double sum = 0;
  for (const double residual : residuals) sum += residual * residual;
  return std::sqrt(sum / static_cast<double>(residuals.size()));
}

/// Largest difference of a fit from its curve, relative to the largest value of the curve.
double largest_difference(const Curve& curve, const double* residuals) {
  double difference = 0, largest = 0;
  for (std::size_t i = 0; i < curve.value.size(); ++i) {
    difference = std::max(difference, std::abs(residuals[i] * curve.deviation[i]));
    largest = std::max(largest, std::abs(curve.value[i]));
  }
  return difference / largest;
}

/// Calls `show(curve, its residuals)` for each curve.
template <class Show>
void for_each_curve(const Fit& fit, const Calibration& found, const Show& show) {
  const double* residuals = found.residuals.data();
  for (const Curve& curve : fit.curves) {
    show(curve, residuals);
    residuals += curve.value.size();
  }
}

}  // namespace

std::string text_of(const Fit& fit, const Calibration& found) {
  std::string text = fmt::format(
      "{} after {} runs; residuals are {:.3g} standard deviations of the data (root mean square)\n",
      found.has_converged ? "converged" : "NOT converged", found.runs,
      root_mean_square(found.residuals));
  for_each_curve(fit, found, [&](const Curve& curve, const double* residuals) {
    text += fmt::format("  {}: within {:.2g} % of its largest value\n", curve.measurement,
                        100 * largest_difference(curve, residuals));
  });
  text += "\n";
  for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
    const Estimated& one = found.parameters[i];
    text += fmt::format("{:<40}{:>12.5g} +- {:<10.2g} {}\n", fit.parameters[i].key, one.value,
                        one.error, text_of(one.determination));
  }
  text += "\nCorrelation:\n";
  for (const auto& row : found.correlation) {
    for (const double value : row) text += fmt::format("{:>8.3f}", value);
    text += "\n";
  }
  return text;
}

std::string json_of(const Fit& fit, const Calibration& found) {
  using Json = nlohmann::ordered_json;
  Json parameters = Json::array(), curves = Json::array();
  for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
    const Estimated& one = found.parameters[i];
    parameters.push_back({{"key", fit.parameters[i].key},
                          {"value", one.value},
                          {"standard_error", one.error},
                          {"determination", text_of(one.determination)}});
  }
  for_each_curve(fit, found, [&](const Curve& curve, const double* residuals) {
    curves.push_back({{"measurement", curve.measurement},
                      {"largest_difference", largest_difference(curve, residuals)}});
  });
  const Json json = {{"converged", found.has_converged},
                     {"runs", found.runs},
                     {"root_mean_square_residual", root_mean_square(found.residuals)},
                     {"parameters", parameters},
                     {"correlation", found.correlation},
                     {"curves", curves}};
  return json.dump(1) + "\n";
}

std::string curves_csv(const Fit& fit, const Calibration& found) {
  std::string text = batch::csv_line({"measurement", "time", "data", "deviation", "fit"});
  const auto number = [](double value) { return fmt::format("{:.10g}", value); };
  for_each_curve(fit, found, [&](const Curve& curve, const double* residuals) {
    for (std::size_t i = 0; i < curve.time.size(); ++i) {
      text += batch::csv_line({curve.measurement, number(curve.time[i]), number(curve.value[i]),
                               number(curve.deviation[i]),
                               number(curve.value[i] + residuals[i] * curve.deviation[i])});
    }
  });
  return text;
}

}  // namespace pliant::calibrate

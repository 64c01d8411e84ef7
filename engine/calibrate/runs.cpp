#include "engine/calibrate/runs.hpp"

#include <fmt/format.h>
#include <hdf5.h>
#include <pliant/error.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/output/hdf5/hdf5.hpp"

namespace pliant::calibrate {

std::vector<double> history_at(const std::filesystem::path& result, const std::string& measurement,
                               const std::vector<double>& times) {
  hdf5::silence();
  const hdf5::Handle file(H5Fopen(result.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose,
                          "open it");
  const std::string group = "measurements/" + measurement;
  if (!hdf5::exists(file, "measurements") || !hdf5::exists(file, group)) {
    throw InputError(
        fmt::format("the case has no measurement `{}`; name one that it has", measurement));
  }
  const std::vector<double> time = hdf5::read_column(file, group + "/time");
  const std::vector<double> value = hdf5::read_column(file, group + "/value");
  std::vector<double> found;
  found.reserve(times.size());
  for (const double t : times) {
    const auto after = std::ranges::lower_bound(time, t * (1 - 1e-12));
    if (after == time.end()) return {};
    const auto i = static_cast<std::size_t>(after - time.begin());
    if (i == 0 && time[0] > t * (1 + 1e-12)) return {};
    const double share = i == 0 ? 0 : (t - time[i - 1]) / (time[i] - time[i - 1]);
    found.push_back(i == 0 ? value[0] : value[i - 1] + share * (value[i] - value[i - 1]));
    if (!std::isfinite(found.back())) return {};
  }
  return found;
}

batch::Assignment Runs::assignment_of(const std::vector<double>& point) const {
  batch::Assignment assignment;
  for (std::size_t i = 0; i < point.size(); ++i) {
    assignment.emplace_back(fit_.parameters[i].key, batch::number_text(point[i]));
  }
  return assignment;
}

std::optional<Residuals> Runs::residuals_of(const std::filesystem::path& folder) const {
  Residuals residuals;
  for (const Curve& curve : fit_.curves) {
    const auto model = history_at(folder / "result.h5", curve.measurement, curve.time);
    if (model.empty()) return std::nullopt;
    for (std::size_t i = 0; i < model.size(); ++i) {
      residuals.push_back((model[i] - curve.value[i]) / curve.deviation[i]);
    }
  }
  return residuals;
}

std::vector<std::optional<Residuals>> Runs::operator()(
    const std::vector<std::vector<double>>& points) {
  batch::Sweep sweep;
  sweep.name = fit_.name;
  sweep.case_file = fit_.case_file;
  sweep.settings = fit_.settings;
  sweep.time_limit = fit_.time_limit;
  for (const auto& point : points) sweep.runs.push_back(assignment_of(point));
  batch::BatchOptions options = options_;
  options.folder = options_.folder / fmt::format("round-{}", ++round_);
  options.quiet = true;
  if (run_batch(sweep, options) == batch::BatchEnd::interrupted) throw Interrupted();
  std::vector<std::optional<Residuals>> found;
  for (const batch::RunRow& row : batch::Ledger(options.folder, batch::Ledger::Use::read).rows()) {
    const bool done = row.status == batch::RunStatus::done;
    found.push_back(done ? residuals_of(options.folder / "runs" / row.name) : std::nullopt);
    if (options_.quiet) continue;
    double sum = 0;
    if (found.back())
      for (const double r : *found.back()) sum += r * r;
    const std::string result =
        done ? fmt::format("sum of squares {:.6g}", sum) : "failed: " + row.outcome.message;
    std::fputs(fmt::format("round {}, {}: {}\n", round_, row.name, result).c_str(), stderr);
  }
  return found;
}

}  // namespace pliant::calibrate

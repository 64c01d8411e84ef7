#include "engine/simulation/histories.hpp"

#include <fmt/format.h>

#include <utility>

#include "engine/simulation/oscillation.hpp"
#include "engine/simulation/pulse.hpp"

namespace pliant {

namespace {

double value_of(const MeasurementCase& m, const std::vector<double>& times,
                const std::vector<double>& of) {
  switch (m.kind) {
    case MeasurementCase::Kind::period:
      return oscillation_period(times, of);
    case MeasurementCase::Kind::amplitude_ratio:
      return amplitude_ratio(times, of);
    case MeasurementCase::Kind::peak_moving_average:
      return peak_moving_average(times, of, m.window);
    default:
      return last_time_above(times, of);
  }
}

}  // namespace

void Histories::add(double time, std::vector<double> values) {
  if (start_.empty()) start_ = latest_ = values;
  const std::vector<double> before = std::exchange(latest_, values);
  const double elapsed = times_.empty() ? 0 : time - times_.back();
  times_.push_back(time);
  for (std::size_t m = 0; m < values.size(); ++m) {
    if (settings_->measurements[m].relative) values[m] /= start_[m];
    if (settings_->measurements[m].is_force()) {
      values[m] = elapsed > 0 ? (values[m] - before[m]) / elapsed : 0;
    }
    rows_[m].push_back(values[m]);
  }
  for (std::size_t m = 0; m < values.size(); ++m) {
    const MeasurementCase& measurement = settings_->measurements[m];
    if (!measurement.reads_history()) continue;
    rows_[m].back() = value_of(measurement, times_, rows_[measurement.of]);
  }
}

void Histories::put(ArchiveWriter& archive) const {
  archive.put("histories/time", std::span<const double>(times_));
  archive.put("histories/start", std::span<const double>(start_));
  archive.put("histories/latest", std::span<const double>(latest_));
  for (std::size_t m = 0; m < rows_.size(); ++m) {
    archive.put(fmt::format("histories/{}", settings_->measurements[m].name),
                std::span<const double>(rows_[m]));
  }
}

void Histories::get(const ArchiveReader& archive) {
  times_ = archive.get<double>("histories/time");
  start_ = archive.get<double>("histories/start");
  latest_ = archive.get<double>("histories/latest");
  for (std::size_t m = 0; m < rows_.size(); ++m) {
    rows_[m] = archive.get<double>(fmt::format("histories/{}", settings_->measurements[m].name));
  }
}

std::string unit_of(const Case& settings, const MeasurementCase& m) {
  using Kind = MeasurementCase::Kind;
  const int dimension = settings.dimension;
  const std::string per_depth = dimension == 2 ? "/m" : "";
  if (m.relative) return "1";
  switch (m.kind) {
    case Kind::extent:
    case Kind::surface_distance:
    case Kind::mean_radius:
    case Kind::point_displacement:
      return "m";
    case Kind::point_value:
      return m.field == "density"              ? "kg/m^3"
             : m.field.starts_with("velocity") ? "m/s"
             : m.field.starts_with("displ")    ? "m"
                                               : "Pa";
    case Kind::mass:
      return "kg" + per_depth;
    case Kind::momentum:
      return "kg m/s" + per_depth;
    case Kind::angular_momentum:
      return "kg m^2/s" + per_depth;
    case Kind::kinetic_energy:
    case Kind::strain_energy:
    case Kind::total_energy:
      return "J" + per_depth;
    case Kind::wall_force:
    case Kind::contact_force:
      return "N" + per_depth;
    case Kind::volume:
      return dimension == 2 ? "m^2" : "m^3";
    case Kind::surface_area:
      return dimension == 2 ? "m" : "m^2";
    case Kind::period:
    case Kind::last_time_above:
      return "s";
    case Kind::peak_moving_average:
      return unit_of(settings, settings.measurements[m.of]);
    case Kind::minimum_particle_distance:
    case Kind::velocity_error:
    case Kind::amplitude_ratio:
    case Kind::energy_ratio:
      return "1";
  }
  return "1";
}

}  // namespace pliant

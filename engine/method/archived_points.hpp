#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/boundaries/walls.hpp"
#include "engine/output/archive/archive.hpp"

/// Points and boundaries in an archive.
namespace pliant {

/// Writes points as one list of components.
template <int D>
void put_points(ArchiveWriter& archive, const std::string& name,
                const std::vector<Point<D>>& points) {
  std::vector<double> values;
  for (const Point<D>& x : points) values.insert(values.end(), x.begin(), x.end());
  archive.put(name, std::span<const double>(values));
}

/// Reads as many points as `points` holds.
template <int D>
void get_points(const ArchiveReader& archive, const std::string& name,
                std::vector<Point<D>>& points) {
  const auto values = archive.get<double>(name);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int a = 0; a < D; ++a) points[i][a] = values.at(D * i + a);
  }
}

/// Writes the offsets and velocities of walls and the loads that replace those of the case. A load
/// that is not replaced is NaN.
template <int D>
void put_boundaries(ArchiveWriter& archive, const Boundaries<D>& boundaries) {
  Point<D> none;
  none.fill(std::numeric_limits<double>::quiet_NaN());
  std::vector<Point<D>> offsets, velocities;
  std::vector<double> angles;
  for (const Wall<D>& wall : boundaries.walls) {
    offsets.push_back(wall.pose().offset);
    angles.push_back(wall.pose().angle);
    velocities.push_back(wall.set_velocity().value_or(none));
  }
  std::vector<double> pressures;
  for (const SurfacePressure<D>& pressure : boundaries.pressures) {
    pressures.push_back(pressure.set_value().value_or(none[0]));
  }
  put_points<D>(archive, "walls/offset", offsets);
  archive.put("walls/angle", std::span<const double>(angles));
  put_points<D>(archive, "walls/set_velocity", velocities);
  archive.put("pressures/set_value", std::span<const double>(pressures));
}

template <int D>
void get_boundaries(const ArchiveReader& archive, Boundaries<D>& boundaries) {
  std::vector<Point<D>> offsets(boundaries.walls.size()), velocities(offsets);
  get_points<D>(archive, "walls/offset", offsets);
  get_points<D>(archive, "walls/set_velocity", velocities);
  const auto angles = archive.get<double>("walls/angle");
  for (std::size_t w = 0; w < offsets.size(); ++w) {
    boundaries.walls[w].restore({offsets[w], angles.at(w)});
    const bool was_set = !std::isnan(velocities[w][0]);
    boundaries.walls[w].set_velocity(was_set ? std::optional(velocities[w]) : std::nullopt);
  }
  const auto pressures = archive.get<double>("pressures/set_value");
  for (std::size_t i = 0; i < boundaries.pressures.size(); ++i) {
    const bool was_set = !std::isnan(pressures.at(i));
    boundaries.pressures[i].set_value(was_set ? std::optional(pressures[i]) : std::nullopt);
  }
}

}  // namespace pliant

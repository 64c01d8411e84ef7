#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/boundaries/walls.hpp"
#include "engine/boundaries/wrench.hpp"
#include "engine/output/archive/archive.hpp"

/// Points, forces with moments, and boundaries in an archive.
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

/// Writes forces and moments as one list of components each.
template <int D>
void put_wrenches(ArchiveWriter& archive, const std::string& name,
                  const std::vector<Wrench<D>>& wrenches) {
  std::vector<Point<D>> forces;
  std::vector<Vector> moments;
  for (const Wrench<D>& wrench : wrenches) {
    forces.push_back(wrench.force);
    moments.push_back(wrench.moment);
  }
  put_points<D>(archive, name, forces);
  put_points<3>(archive, name + "_moment", moments);
}

/// Reads as many as `wrenches` holds.
template <int D>
void get_wrenches(const ArchiveReader& archive, const std::string& name,
                  std::vector<Wrench<D>>& wrenches) {
  std::vector<Point<D>> forces(wrenches.size());
  std::vector<Vector> moments(wrenches.size());
  get_points<D>(archive, name, forces);
  get_points<3>(archive, name + "_moment", moments);
  for (std::size_t w = 0; w < wrenches.size(); ++w) wrenches[w] = {forces[w], moments[w]};
}

/// Writes displacements and angles of walls.
template <int D>
void put_poses(ArchiveWriter& archive, const std::string& name,
               const std::vector<WallPose<D>>& poses) {
  std::vector<Point<D>> offsets;
  std::vector<double> angles;
  for (const WallPose<D>& pose : poses) {
    offsets.push_back(pose.offset);
    angles.push_back(pose.angle);
  }
  put_points<D>(archive, name + "_offset", offsets);
  archive.put(name + "_angle", std::span<const double>(angles));
}

/// Reads as many as `poses` holds.
template <int D>
void get_poses(const ArchiveReader& archive, const std::string& name,
               std::vector<WallPose<D>>& poses) {
  std::vector<Point<D>> offsets(poses.size());
  get_points<D>(archive, name + "_offset", offsets);
  const auto angles = archive.get<double>(name + "_angle");
  for (std::size_t w = 0; w < poses.size(); ++w) poses[w] = {offsets[w], angles.at(w)};
}

/// Writes the poses and velocities of walls and the loads that replace those of the case. A load
/// that is not replaced is NaN.
template <int D>
void put_boundaries(ArchiveWriter& archive, const Boundaries<D>& boundaries) {
  Point<D> none;
  none.fill(std::numeric_limits<double>::quiet_NaN());
  std::vector<WallPose<D>> poses;
  std::vector<Point<D>> velocities;
  for (const Wall<D>& wall : boundaries.walls) {
    poses.push_back(wall.pose());
    velocities.push_back(wall.set_velocity().value_or(none));
  }
  std::vector<double> pressures;
  for (const SurfacePressure<D>& pressure : boundaries.pressures) {
    pressures.push_back(pressure.set_value().value_or(none[0]));
  }
  put_poses<D>(archive, "walls/present", poses);
  put_points<D>(archive, "walls/set_velocity", velocities);
  archive.put("pressures/set_value", std::span<const double>(pressures));
}

template <int D>
void get_boundaries(const ArchiveReader& archive, Boundaries<D>& boundaries) {
  std::vector<WallPose<D>> poses(boundaries.walls.size());
  std::vector<Point<D>> velocities(poses.size());
  get_poses<D>(archive, "walls/present", poses);
  get_points<D>(archive, "walls/set_velocity", velocities);
  for (std::size_t w = 0; w < poses.size(); ++w) {
    boundaries.walls[w].restore(poses[w]);
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

#pragma once

#include <string>
#include <vector>

#include "engine/boundaries/walls.hpp"
#include "engine/output/archive.hpp"

/// Points in an archive, and where walls have got to.
namespace pliant {

template <int D>
void put_points(ArchiveWriter& archive, const std::string& name,
                const std::vector<Point<D>>& points) {
  std::vector<double> values;
  for (const Point<D>& x : points) values.insert(values.end(), x.begin(), x.end());
  archive.put(name, std::span<const double>(values));
}

/// As many as `points` holds.
template <int D>
void get_points(const ArchiveReader& archive, const std::string& name,
                std::vector<Point<D>>& points) {
  const auto values = archive.get<double>(name);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int a = 0; a < D; ++a) points[i][a] = values.at(D * i + a);
  }
}

template <int D>
void put_offsets(ArchiveWriter& archive, const std::vector<Wall<D>>& walls) {
  std::vector<Point<D>> offsets;
  offsets.reserve(walls.size());
  for (const Wall<D>& wall : walls) offsets.push_back(wall.offset());
  put_points<D>(archive, "walls/offset", offsets);
}

template <int D>
void get_offsets(const ArchiveReader& archive, std::vector<Wall<D>>& walls) {
  std::vector<Point<D>> offsets(walls.size());
  get_points<D>(archive, "walls/offset", offsets);
  for (std::size_t w = 0; w < walls.size(); ++w) walls[w].restore(offsets[w]);
}

}  // namespace pliant

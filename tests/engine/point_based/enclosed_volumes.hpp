#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "engine/point_based/observe/opened_surface.hpp"

namespace pliant::test {

/// Volumes inside the connected parts of a closed surface, in ascending order; areas in 2D.
template <int D>
std::vector<double> volumes_of(const point_based::SurfaceVertices& vertices) {
  std::vector<std::int64_t> root(vertices.owner.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](std::int64_t v) {
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  const std::size_t pieces = vertices.vertex.size() / D;
  for (std::size_t p = 0; p < pieces; ++p) {
    for (int k = 1; k < D; ++k) {
      root[find(vertices.vertex[D * p + k])] = find(vertices.vertex[D * p]);
    }
  }
  std::map<std::int64_t, double> volume;
  for (std::size_t p = 0; p < pieces; ++p) {
    Eigen::Matrix<double, D, D> corners;
    for (int k = 0; k < D; ++k) {
      for (int a = 0; a < D; ++a) {
        corners(a, k) = vertices.position[3 * vertices.vertex[D * p + k] + a] - 0.5;
      }
    }
    volume[find(vertices.vertex[D * p])] += corners.determinant() / (D == 2 ? 2 : 6);
  }
  std::vector<double> volumes;
  volumes.reserve(volume.size());
  for (const auto& [part, of_part] : volume) volumes.push_back(of_part);
  std::sort(volumes.begin(), volumes.end());
  return volumes;
}

/// Whether each ridge belongs to as many pieces in one direction as in the other.
template <int D>
bool is_closed(const point_based::SurfaceVertices& vertices) {
  std::map<std::pair<std::int64_t, std::int64_t>, int> balance;
  for (std::size_t p = 0; p < vertices.vertex.size() / D; ++p) {
    for (int k = 0; k < D; ++k) {
      const std::int64_t a = vertices.vertex[D * p + k];
      const std::int64_t b = D == 2 ? -1 : vertices.vertex[D * p + (k + 1) % D];
      balance[std::minmax(a, b)] += (D == 2 ? k == 0 : a < b) ? 1 : -1;
    }
  }
  return std::all_of(balance.begin(), balance.end(),
                     [](const auto& ridge) { return ridge.second == 0; });
}

}  // namespace pliant::test

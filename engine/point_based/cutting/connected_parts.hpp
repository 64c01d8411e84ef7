#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace pliant::point_based {

/// The parts into which cuts divide a body.
struct ConnectedParts {
  std::vector<std::int32_t> part_of;  ///< [node] parts are numbered by their first nodes
  std::vector<double> volumes;        ///< [part] sum of its nodes' volumes
};

/// Nodes are joined by bonds with a factor other than zero. Node i has the bonds first[i] ..
/// first[i + 1] - 1 to `neighbour`.
ConnectedParts connected_parts(std::span<const std::int64_t> first,
                               std::span<const std::int32_t> neighbour,
                               std::span<const double> factors, std::span<const double> volumes);

}  // namespace pliant::point_based

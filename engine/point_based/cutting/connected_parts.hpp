#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace pliant::point_based {

/// The parts into which cuts have divided a body.
struct ConnectedParts {
  std::vector<std::int32_t> part_of;  ///< [node] numbered by the first node of each
  std::vector<double> volumes;        ///< [part] sum of its nodes' volumes
};

/// Joins nodes by their bonds with weight: node i has the bonds first[i] .. first[i + 1] - 1 to
/// `neighbour`, each with a factor; those of factor zero join nothing.
ConnectedParts connected_parts(std::span<const std::int64_t> first,
                               std::span<const std::int32_t> neighbour,
                               std::span<const double> factors, std::span<const double> volumes);

}  // namespace pliant::point_based

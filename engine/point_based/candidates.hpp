#pragma once

#include <string>
#include <vector>

#include "engine/point_based/nearest_nodes.hpp"
#include "engine/point_based/nodes/node_cloud.hpp"

namespace pliant::point_based {

/// The `count` nodes nearest to each, or all others where there are fewer; of a node with an
/// elastic volume, those with one too, (PB.21). Throws InputError, in the name of `body`, for two
/// nodes at one place and for a cloud of one node.
template <int D>
std::vector<std::vector<typename NearestNodes<D>::Found>> find_candidates(
    const NodeCloud<D>& cloud, const std::vector<double>& elastic_volumes, int count,
    const std::string& body);

}  // namespace pliant::point_based

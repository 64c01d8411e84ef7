#pragma once

#include <vector>

#include "engine/point_based/body.hpp"
#include "engine/point_based/nodes/node_cloud.hpp"

namespace pliant::point_based {

/// Neighbours of every node of a cloud.
struct Neighbours {
  std::vector<std::vector<std::int32_t>> node;  ///< [node] nearest first
  std::vector<double> support;                  ///< [node] h of (PB.2) [m]
};

/// The support radius over the spacing that gives a node inside a lattice `count` neighbours,
/// (PB.2).
template <int D>
double lattice_support(int count);

/// The `count` nodes nearest to each, or all others where there are fewer, no farther away than the
/// largest support radius [m]. Throws InputError, in the name of `body`, for two nodes at one place
/// and for a cloud of one node.
template <int D>
Neighbours find_neighbours(const NodeCloud<D>& cloud, int count, double largest_support,
                           const std::string& body);

/// Bonds between the nodes of a body whose blocks, places and volumes are known, (PB.2)-(PB.3):
/// neighbours, gradients, moments, halos, and which blocks are near each other. `alpha` is the
/// strength of the stabilisation (PB.5).
template <class T, int D>
void make_bonds(const Neighbours& neighbours, double alpha, Body<T, D>& body);

}  // namespace pliant::point_based

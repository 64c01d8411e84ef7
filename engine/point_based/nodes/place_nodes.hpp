#pragma once

#include <limits>
#include <vector>

#include "engine/boundaries/walls.hpp"
#include "engine/case/case.hpp"
#include "engine/point_based/nodes/node_cloud.hpp"

namespace pliant::point_based {

/// Whether a shape is a mesh of tetrahedra, in 2D of triangles.
bool has_elements(const Shape& shape);

/// The nodes of a body of a case.
template <int D>
struct PlacedNodes {
  NodeCloud<D> cloud;
  std::vector<double> elastic_volumes;  ///< [node] of (PB.21) [m^D]
  std::vector<double> reach;            ///< [node] a wall holds nodes within this distance [m]
  /// [axis] factors that stretch the cells of the nodes' lattice to cubes, for distances in (PB.2)
  Point<D> stretch = stretch_of_cubes();
  /// h of (PB.2) [m]; infinite: from the distances of the nodes
  double support = std::numeric_limits<double>::infinity();
  double alpha = 0.3;  ///< stabilisation strength (PB.5) for this placement

  /// The places that the distances of (PB.2) are taken between.
  std::vector<Point<D>> stretched() const {
    std::vector<Point<D>> places = cloud.positions;
    for (Point<D>& x : places) {
      for (int a = 0; a < D; ++a) x[a] *= stretch[a];
    }
    return places;
  }

  static constexpr Point<D> stretch_of_cubes() {
    Point<D> ones = {};
    for (double& one : ones) one = 1;
    return ones;
  }
};

/// Places the nodes of a body: from a mesh of tetrahedra, on a lattice whose nodes move onto walls
/// within half a spacing, or in an octree. Throws InputError for a body that holds none.
template <int D>
PlacedNodes<D> place_nodes(const Case& settings, const BodyCase& source,
                           const Boundaries<D>& boundaries);

}  // namespace pliant::point_based

#pragma once

#include <limits>
#include <vector>

#include "engine/point_based/bonds/bonds.hpp"
#include "engine/point_based/nodes/node_cloud.hpp"
#include "engine/point_based/state.hpp"

namespace pliant::point_based {

/// Whether a shape is a mesh of tetrahedra, in 2D of triangles.
bool has_elements(const Shape& shape);

/// Whether blades of the case cut one of its bodies.
bool has_cuts(const Case& settings, const BodyCase& body);

/// The nodes of a body of a case.
template <int D>
struct PlacedNodes {
  NodeCloud<D> cloud;
  std::vector<double> elastic_volumes;  ///< [node] of (PB.21) [m^D]
  double reach = 0;  ///< distance within which a wall holds a node, over the node's V^(1/D)
  /// [axis] what stretches the cells of the nodes' lattice to cubes, for distances in (PB.2)
  Point<D> stretch = stretch_of_cubes();
  /// h of (PB.2) [m]; infinite: from the distances of the nodes
  double support = std::numeric_limits<double>::infinity();
  double alpha = 0.3;  ///< strength of the stabilisation (PB.5) that they need

  /// Where nodes are for the distances of (PB.2).
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

/// Places nodes: those of the tetrahedra of a mesh, on a lattice whose nodes move onto walls within
/// half a spacing, or in an octree. Throws InputError for a body that holds none.
template <int D>
PlacedNodes<D> place_nodes(const Case& settings, const BodyCase& source,
                           const Boundaries<D>& boundaries);

/// What turns pressures into forces: the kernel that evaluates the bonds, or NodeLoads.
enum class PressureForces { of_bonds, of_loads };

/// Everything of make_body but the bonds.
template <class T, int D>
void make_nodes(const Case& settings, const BodyCase& source, const PlacedNodes<D>& nodes,
                const Boundaries<D>& boundaries, PressureForces pressures, Body<T, D>& body);

/// Makes a body of a case from its nodes, at rest or with the case's initial velocity. Throws
/// InputError for nodes that are no body. Returns how nodes have taken their neighbours.
template <class T, int D>
BondChoice<D> make_body(const Case& settings, const BodyCase& source, const PlacedNodes<D>& nodes,
                        const Boundaries<D>& boundaries, Body<T, D>& body);

/// Numbers the blocks of all bodies, and returns which are near each other.
template <class T, int D>
scheduler::Blocks number_blocks(State<T, D>& state);

}  // namespace pliant::point_based

#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace pliant::point_based {

/// The nodes of a body in its undeformed state, in SI units; D is the dimension.
template <int D>
struct NodeCloud {
  std::vector<std::array<double, D>> positions;  ///< [node][axis] [m]; no two at the same place
  std::vector<double> volumes;  ///< [node] positive [m^3], 2D [m^2]; sum: the volume of the body
  /// [element] nodes of the triangles (2D, counter-clockwise) or tetrahedra (3D, positive volume)
  /// that fill the body; empty where the nodes do not come from a mesh.
  std::vector<std::array<std::int32_t, D + 1>> elements;
  bool is_regular = false;  ///< whether the nodes are all points of a lattice, which none has left
};

}  // namespace pliant::point_based

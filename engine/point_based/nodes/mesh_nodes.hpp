#pragma once

#include "engine/geometry/volume_mesh.hpp"
#include "engine/point_based/nodes/node_cloud.hpp"

namespace pliant::point_based {

/// Walls hold the nodes of a mesh within this distance, in units of V^(1/D): vertices lie on the
/// surface.
inline constexpr double reach_of_walls_in_meshes = 0.25;

/// One node at every vertex of a mesh of dimension D. Each element gives 1/(D + 1) of its volume to
/// each corner, so node volumes sum to that of the mesh. Positions are `scale` times those of the
/// file plus `translate`; `scale` is in metres per unit of the file.
template <int D>
NodeCloud<D> nodes_of_mesh(const VolumeMesh& mesh, double scale, const Vector& translate);

extern template NodeCloud<2> nodes_of_mesh<2>(const VolumeMesh&, double, const Vector&);
extern template NodeCloud<3> nodes_of_mesh<3>(const VolumeMesh&, double, const Vector&);

}  // namespace pliant::point_based

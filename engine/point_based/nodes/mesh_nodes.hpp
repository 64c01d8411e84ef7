#pragma once

#include "engine/geometry/volume_mesh.hpp"
#include "engine/point_based/nodes/node_cloud.hpp"

namespace pliant::point_based {

/// One node at every vertex of a mesh of dimension D. Each element gives 1/(D + 1) of its volume to
/// each corner, so node volumes sum to that of the mesh. Positions are `scale` times those of the
/// file plus `translate`; `scale` is in metres per unit of the file.
template <int D>
NodeCloud<D> nodes_of_mesh(const VolumeMesh& mesh, double scale, const Vector& translate);

/// [node] distance within which a wall holds a node of a mesh, whose vertices lie on its surface: a
/// quarter of the side of the cubes, in 2D squares, whose D! elements are as large as the mean of
/// those at the node [m].
template <int D>
std::vector<double> reach_of_walls(const NodeCloud<D>& cloud);

extern template std::vector<double> reach_of_walls<2>(const NodeCloud<2>&);
extern template std::vector<double> reach_of_walls<3>(const NodeCloud<3>&);
extern template NodeCloud<2> nodes_of_mesh<2>(const VolumeMesh&, double, const Vector&);
extern template NodeCloud<3> nodes_of_mesh<3>(const VolumeMesh&, double, const Vector&);

}  // namespace pliant::point_based

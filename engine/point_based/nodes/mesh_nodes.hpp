#pragma once

#include "engine/geometry/volume_mesh.hpp"
#include "engine/point_based/nodes/node_cloud.hpp"

namespace pliant::point_based {

/// A node at every vertex of a mesh of dimension D. Each element gives an equal part of its volume,
/// 1/(D + 1), to each of its corners: their volumes sum to the volume of the mesh. Positions are
/// `scale` times those of the file plus `translate`; `scale` in metres per unit of the file.
template <int D>
NodeCloud<D> nodes_of_mesh(const VolumeMesh& mesh, double scale, const Vector& translate);

extern template NodeCloud<2> nodes_of_mesh<2>(const VolumeMesh&, double, const Vector&);
extern template NodeCloud<3> nodes_of_mesh<3>(const VolumeMesh&, double, const Vector&);

}  // namespace pliant::point_based

#include "engine/point_based/nodes/mesh_nodes.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace pliant::point_based {

template <int D>
NodeCloud<D> nodes_of_mesh(const VolumeMesh& mesh, double scale, const Vector& translate) {
  assert(mesh.dimension == D);
  NodeCloud<D> cloud;
  cloud.positions.reserve(mesh.vertices.size());
  for (const Vector& vertex : mesh.vertices) {
    std::array<double, D>& x = cloud.positions.emplace_back();
    for (int a = 0; a < D; ++a) x[a] = scale * vertex[a] + translate[a];
  }
  cloud.volumes.assign(mesh.vertices.size(), 0.);
  cloud.elements.resize(mesh.elements.size());
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    std::copy_n(mesh.elements[e].begin(), D + 1, cloud.elements[e].begin());
    const double share = element_volume(mesh, e) * std::pow(scale, D) / (D + 1);
    for (const std::int32_t corner : cloud.elements[e]) cloud.volumes[corner] += share;
  }
  return cloud;
}

template NodeCloud<2> nodes_of_mesh<2>(const VolumeMesh&, double, const Vector&);
template NodeCloud<3> nodes_of_mesh<3>(const VolumeMesh&, double, const Vector&);

}  // namespace pliant::point_based

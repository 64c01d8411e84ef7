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

template <int D>
std::vector<double> reach_of_walls(const NodeCloud<D>& cloud) {
  constexpr int elements_of_cube = D == 2 ? 2 : 6;
  std::vector<int> count(cloud.positions.size(), 0);
  for (const std::array<std::int32_t, D + 1>& corners : cloud.elements) {
    for (const std::int32_t corner : corners) ++count[corner];
  }
  std::vector<double> reach;
  for (std::size_t i = 0; i < count.size(); ++i) {
    const double mean = (D + 1) * cloud.volumes[i] / count[i];
    reach.push_back(0.25 * std::pow(elements_of_cube * mean, 1. / D));
  }
  return reach;
}

template std::vector<double> reach_of_walls<2>(const NodeCloud<2>&);
template std::vector<double> reach_of_walls<3>(const NodeCloud<3>&);
template NodeCloud<2> nodes_of_mesh<2>(const VolumeMesh&, double, const Vector&);
template NodeCloud<3> nodes_of_mesh<3>(const VolumeMesh&, double, const Vector&);

}  // namespace pliant::point_based

#include "engine/geometry/mesh_files/volume_mesh_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pliant {
namespace {

std::string_view element_word(int dimension) { return dimension == 3 ? "tetrahedron" : "triangle"; }

double longest_edge(const VolumeMesh& mesh, std::size_t e) {
  double longest = 0;
  for (int a = 0; a <= mesh.dimension; ++a) {
    for (int b = 0; b < a; ++b) {
      const Vector &p = mesh.vertices[mesh.elements[e][a]], &q = mesh.vertices[mesh.elements[e][b]];
      longest = std::max(longest, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
    }
  }
  return longest;
}

}  // namespace

void VolumeMeshRows::refuse(std::size_t offset, const std::string& what,
                            const std::string& remedy) const {
  if (is_text_) file_.refuse_line(offset, what, remedy);
  file_.refuse_byte(offset, what, remedy);
}

void VolumeMeshRows::add_node(std::size_t offset, std::int64_t tag, const Vector& position) {
  for (const double x : position) {
    if (!std::isfinite(x)) {
      refuse(offset, fmt::format("the position of node {} is not finite", tag),
             "remove the node, or give it a position");
    }
  }
  if (!index_of_.try_emplace(tag, static_cast<std::int32_t>(nodes_.size())).second) {
    refuse(offset, fmt::format("the number {} has two nodes", tag), std::string(save_again));
  }
  nodes_.push_back(position);
  node_at_.push_back(offset);
}

bool VolumeMeshRows::takes(std::size_t offset, int element_dimension, int corners,
                           std::string_view name) const {
  if (element_dimension == dimension_ && corners == dimension_ + 1) return true;
  if (element_dimension < dimension_) return false;
  refuse(offset, fmt::format("an element of the kind {} cannot be read", name),
         dimension_ == 3 ? "mesh the body with tetrahedra of four nodes (order 1)"
                         : "mesh the body with triangles of three nodes (order 1)");
}

void VolumeMeshRows::add_element(std::size_t offset, const std::int64_t* tags) {
  std::array<std::int32_t, 4> corners = {-1, -1, -1, -1};
  for (int k = 0; k <= dimension_; ++k) {
    const auto found = index_of_.find(tags[k]);
    if (found == index_of_.end()) {
      refuse(offset,
             fmt::format("a {} has the node {}, which the file does not hold",
                         element_word(dimension_), tags[k]),
             std::string(save_again));
    }
    corners[k] = found->second;
  }
  elements_.push_back(corners);
  element_at_.push_back(offset);
}

VolumeMesh VolumeMeshRows::mesh() const {
  if (elements_.empty()) {
    throw MeshError(fmt::format("{}: holds no {}", file_.name, element_word(dimension_)),
                    dimension_ == 3 ? "mesh the volume, and save all its elements"
                                    : "mesh the area, and save all its elements");
  }
  VolumeMesh mesh{dimension_, nodes_, elements_};
  std::vector<std::size_t> node_at = node_at_;
  drop_unused(mesh, node_at);
  check_nodes(mesh, node_at);
  orient(mesh);
  check_facets(mesh);
  return mesh;
}

void VolumeMeshRows::drop_unused(VolumeMesh& mesh, std::vector<std::size_t>& node_at) const {
  std::vector<std::int32_t> kept(mesh.vertices.size(), -1);
  for (const auto& corners : mesh.elements) {
    for (int k = 0; k <= dimension_; ++k) kept[corners[k]] = 0;
  }
  std::int32_t count = 0;
  for (std::size_t v = 0; v < kept.size(); ++v) {
    if (kept[v] < 0) continue;
    mesh.vertices[count] = mesh.vertices[v];
    node_at[count] = node_at[v];
    kept[v] = count++;
  }
  mesh.vertices.resize(count);
  for (auto& corners : mesh.elements) {
    for (int k = 0; k <= dimension_; ++k) corners[k] = kept[corners[k]];
  }
}

void VolumeMeshRows::check_nodes(const VolumeMesh& mesh,
                                 const std::vector<std::size_t>& node_at) const {
  std::vector<std::int32_t> order(mesh.vertices.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return mesh.vertices[a] < mesh.vertices[b];
  });
  for (std::size_t i = 1; i < order.size(); ++i) {
    const Vector& x = mesh.vertices[order[i]];
    if (x != mesh.vertices[order[i - 1]]) continue;
    refuse(node_at[order[i]], fmt::format("two nodes are at ({}, {}, {})", x[0], x[1], x[2]),
           "join duplicate nodes (in Gmsh: Coherence Mesh), so that the parts of the mesh connect");
  }
  if (dimension_ == 3) return;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (mesh.vertices[v][2] == 0) continue;
    refuse(node_at[v], fmt::format("a node has z = {} in a 2D case", mesh.vertices[v][2]),
           "put the mesh into the plane z = 0");
  }
}

void VolumeMeshRows::orient(VolumeMesh& mesh) const {
  std::vector<double> volumes(mesh.elements.size());
  for (std::size_t e = 0; e < volumes.size(); ++e) volumes[e] = element_volume(mesh, e);
  if (std::none_of(volumes.begin(), volumes.end(), [](double volume) { return volume > 0; })) {
    for (auto& corners : mesh.elements) std::swap(corners[0], corners[1]);
    for (double& volume : volumes) volume = -volume;
  }
  for (std::size_t e = 0; e < volumes.size(); ++e) {
    const double least = 1e-14 * std::pow(longest_edge(mesh, e), dimension_);  // rounding
    if (volumes[e] > least) continue;
    refuse(element_at_[e],
           fmt::format("this {} is {}: its {} is {:.6g}", element_word(dimension_),
                       volumes[e] < -least ? "inverted" : "flat",
                       dimension_ == 3 ? "volume" : "area", volumes[e]),
           "mesh the body again, or exchange two of its nodes if it is inverted");
  }
}

void VolumeMeshRows::check_facets(const VolumeMesh& mesh) const {
  struct Facet {
    std::array<std::int32_t, 3> corners;
    std::size_t element;
  };
  std::vector<Facet> facets;
  facets.reserve(mesh.elements.size() * (dimension_ + 1));
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    for (int skipped = 0; skipped <= dimension_; ++skipped) {
      Facet facet{{-1, -1, -1}, e};
      for (int k = 0, n = 0; k <= dimension_; ++k) {
        if (k != skipped) facet.corners[n++] = mesh.elements[e][k];
      }
      std::sort(facet.corners.begin(), facet.corners.end());
      facets.push_back(facet);
    }
  }
  std::stable_sort(facets.begin(), facets.end(),
                   [](const Facet& a, const Facet& b) { return a.corners < b.corners; });
  for (std::size_t i = 2; i < facets.size(); ++i) {
    if (facets[i].corners != facets[i - 2].corners) continue;
    refuse(element_at_[facets[i].element],
           fmt::format("this {} shares a facet with two others", element_word(dimension_)),
           "remove double elements, so that each part of the body is filled once");
  }
}

}  // namespace pliant

#include "engine/point_based/surface/surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "engine/geometry/padded.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/point_based/bonds/nearest_nodes.hpp"
#include "engine/point_based/surface/node_loads_of_facets.hpp"
#include "engine/point_based/surface/rectangles.hpp"
#include "engine/point_based/surface/sharp_edges.hpp"
#include "engine/point_based/surface/surface_lattice.hpp"

namespace pliant::point_based {

namespace {

using undeformed::area_vector;

/// Finds a surface whose corners refer to nodes of the cloud.
template <int D>
class SurfaceFinder {
 public:
  SurfaceFinder(const NodeCloud<D>& cloud, double spacing)
      : cloud_(cloud), nearest_(cloud.positions), spacing_(spacing) {}

  /// The facets that belong to only one element.
  BodySurface<D> of_elements() {
    std::map<std::array<std::int32_t, D>, std::array<std::int32_t, D>> alone;
    for (const auto& element : cloud_.elements) {
      for (int left_out = 0; left_out <= D; ++left_out) {
        std::array<std::int32_t, D> facet;
        for (int i = 0, to = 0; i <= D; ++i) {
          if (i != left_out) facet[to++] = element[i];
        }
        if (is_in_front(facet, element[left_out])) std::swap(facet[0], facet[1]);
        std::array<std::int32_t, D> key = facet;
        std::sort(key.begin(), key.end());
        const auto [at, is_new] = alone.insert({key, facet});
        if (!is_new) alone.erase(at);
      }
    }
    for (const auto& [key, facet] : alone) {
      std::array<std::int32_t, D> corner;
      for (int v = 0; v < D; ++v) {
        corner[v] = add({facet[v], facet[v]}, cloud_.positions[facet[v]], facet[v]);
      }
      surface_.facet.push_back(corner);
    }
    return std::move(surface_);
  }

  // Distances to meshes are expensive, and edges of meshes are seldom as sharp as those of boxes.
  BodySurface<D> of_shape(const Shape& shape, bool has_cuts) {
    if (!contains_mesh(shape)) surface_.shape = &shape;
    surface_.spacing = spacing_;
    for (const auto& piece : SurfaceLattice<D>(shape, spacing_).facets()) {
      std::array<std::int32_t, D> corner;
      for (int v = 0; v < D; ++v) corner[v] = add(piece[v].name, piece[v].place, -1);
      surface_.facet.push_back(corner);
    }
    // Cuts divide the simplices that these facets bound.
    if (surface_.shape != nullptr && !has_cuts) sharpen_edges<D>(shape, surface_);
    pair_halves<D>(surface_);
    return std::move(surface_);
  }

 private:
  bool is_in_front(const std::array<std::int32_t, D>& facet, std::int32_t node) const {
    std::array<Point<D>, D> corner;
    for (int v = 0; v < D; ++v) corner[v] = cloud_.positions[facet[v]];
    const Point<D> normal = area_vector<D>(corner);
    double along = 0;
    for (int a = 0; a < D; ++a) along += normal[a] * (cloud_.positions[node][a] - corner[0][a]);
    return along > 0;
  }

  /// The corner with this name; for `node` -1 it refers to the nearest node.
  std::int32_t add(const std::pair<std::int64_t, std::int64_t>& name, const Point<D>& x,
                   std::int32_t node) {
    const auto number = static_cast<std::int32_t>(surface_.start.size());
    const auto [at, is_new] = known_.insert({name, number});
    if (!is_new) return at->second;
    surface_.start.push_back(x);
    surface_.node.push_back(node >= 0 ? node : nearest_.nearest(x));
    return number;
  }

  const NodeCloud<D>& cloud_;
  NearestNodes<D> nearest_;
  double spacing_;
  std::map<std::pair<std::int64_t, std::int64_t>, std::int32_t> known_;
  BodySurface<D> surface_;
};

}  // namespace

template <class T, int D>
void make_loads(const Boundaries<D>& boundaries, Body<T, D>& body) {
  body.pressed.assign(body.blocks.size(), {});
  for (int k = 0; k < static_cast<int>(boundaries.pressures.size()); ++k) {
    std::size_t b = 0;
    for (auto& [slot, node] : NodesUnderLoad<T, D>(boundaries, k, body)()) {
      while (slot >= body.blocks[b].first + body.blocks[b].count) ++b;
      body.pressed[b].push_back(node);
    }
  }
}

template <class T, int D>
void make_surface(const NodeCloud<D>& cloud, const Shape& shape, double spacing,
                  const Boundaries<D>& boundaries, Body<T, D>& body) {
  SurfaceFinder<D> finder(cloud, spacing);
  body.surface =
      cloud.elements.empty() ? finder.of_shape(shape, body.has_cuts()) : finder.of_elements();
  std::vector<std::int32_t> slot_of(cloud.positions.size());
  for (std::int64_t s = 0; s < body.slots; ++s) {
    if (body.number[s] >= 0) slot_of[body.number[s]] = static_cast<std::int32_t>(s);
  }
  for (std::int32_t& node : body.surface.node) node = slot_of[node];
  if (body.has_cuts()) {
    body.elements = cloud.elements;
    for (auto& element : body.elements) {
      for (std::int32_t& node : element) node = slot_of[node];
    }
  }
  for (const auto& facet : body.surface.facet) {
    Point<D> middle = {};
    for (const std::int32_t corner : facet) {
      for (int a = 0; a < D; ++a) middle[a] += body.surface.start[corner][a] / D;
    }
    body.surface.is_free.push_back(!lies_on_a_wall<D>(boundaries, middle, spacing));
  }
}

template <int D>
std::function<bool(const Point<D>&)> inside_of(const Shape& shape, double edge) {
  return
      [shape, edge](const Point<D>& x) { return signed_distance(shape, padded<D>(x), D) < -edge; };
}

template std::function<bool(const Point<2>&)> inside_of<2>(const Shape&, double);
template std::function<bool(const Point<3>&)> inside_of<3>(const Shape&, double);
template void make_loads(const Boundaries<2>&, Body<double, 2>&);
template void make_loads(const Boundaries<3>&, Body<double, 3>&);
template void make_loads(const Boundaries<2>&, Body<float, 2>&);
template void make_loads(const Boundaries<3>&, Body<float, 3>&);
template void make_surface<double, 2>(const NodeCloud<2>&, const Shape&, double,
                                      const Boundaries<2>&, Body<double, 2>&);
template void make_surface<double, 3>(const NodeCloud<3>&, const Shape&, double,
                                      const Boundaries<3>&, Body<double, 3>&);
template void make_surface<float, 2>(const NodeCloud<2>&, const Shape&, double,
                                     const Boundaries<2>&, Body<float, 2>&);
template void make_surface<float, 3>(const NodeCloud<3>&, const Shape&, double,
                                     const Boundaries<3>&, Body<float, 3>&);

}  // namespace pliant::point_based

#include "engine/point_based/cut_faces/divided_edges.hpp"

#include <algorithm>

#include "engine/point_based/cut_faces/meeting_point.hpp"
#include "engine/undeformed/body.hpp"

namespace pliant::point_based {

template <int D>
Column<D> facet_normal(const std::vector<Point<D>>& places,
                       const std::array<std::int32_t, D>& facet) {
  std::array<Point<D>, D> corners;
  for (int v = 0; v < D; ++v) corners[v] = places[facet[v]];
  const Point<D> area = undeformed::area_vector<D>(corners);
  return column<D>(area).normalized();
}

template <int D>
DividedEdges<D>::DividedEdges(const Simplices<D>& body,
                              const std::vector<std::array<std::int32_t, D>>& facets,
                              const CutPieces<D>& pieces) {
  std::vector<Edge> edges;
  for (const auto& simplex : body.simplices) {
    for (int i = 0; i <= D; ++i) {
      for (int j = 0; j < i; ++j) {
        edges.push_back({std::min(simplex[i], simplex[j]), std::max(simplex[i], simplex[j])});
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::map<Edge, std::vector<Column<D>>> held;
  for (const Edge& edge : edges) {
    auto crossings = pieces.crossings(body.places[edge[0]], body.places[edge[1]]);
    if (crossings.empty()) continue;
    if (crossings.size() > 1) held.insert({edge, {}});
    edges_.insert({edge, {column<D>(crossings.front().place), std::move(crossings)}});
  }
  for (const auto& facet : facets) {
    for (int v = 0; v < D; ++v) {
      const std::int32_t a = facet[v], b = facet[(v + 1) % D];
      const auto at = held.find({std::min(a, b), std::max(a, b)});
      if (at != held.end()) at->second.push_back(facet_normal<D>(body.places, facet));
    }
  }
  for (const auto& [edge, normals] : held) {
    const double length =
        (column<D>(body.places[edge[1]]) - column<D>(body.places[edge[0]])).norm();
    DividedEdge<D>& divided = edges_.at(edge);
    divided.point = meeting_point<D>(divided.crossings, normals, length);
  }
}

template <int D>
const DividedEdge<D>* DividedEdges<D>::find(std::int32_t a, std::int32_t b) const {
  const auto at = edges_.find({std::min(a, b), std::max(a, b)});
  return at == edges_.end() ? nullptr : &at->second;
}

template Column<2> facet_normal<2>(const std::vector<Point<2>>&,
                                   const std::array<std::int32_t, 2>&);
template Column<3> facet_normal<3>(const std::vector<Point<3>>&,
                                   const std::array<std::int32_t, 3>&);
template class DividedEdges<2>;
template class DividedEdges<3>;

}  // namespace pliant::point_based

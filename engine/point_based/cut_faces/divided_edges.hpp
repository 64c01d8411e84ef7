#pragma once

#include <array>
#include <map>
#include <vector>

#include "engine/lattice/column.hpp"
#include "engine/point_based/cut_faces/body_simplices.hpp"
#include "engine/point_based/cut_faces/cut_pieces.hpp"

namespace pliant::point_based {

/// The outward unit normal of a facet of a surface.
template <int D>
Column<D> facet_normal(const std::vector<Point<D>>& places,
                       const std::array<std::int32_t, D>& facet);

/// An edge of a simplex that cuts cross, (PB.30).
template <int D>
struct DividedEdge {
  Column<D> point;  ///< of the cut [m]
  std::vector<typename CutPieces<D>::Crossed> crossings;
};

/// The edges of simplices that cuts cross.
template <int D>
class DividedEdges {
 public:
  /// `facets` are those of the body's surface; points of cuts on their edges stay on the surface.
  DividedEdges(const Simplices<D>& body, const std::vector<std::array<std::int32_t, D>>& facets,
               const CutPieces<D>& pieces);

  /// The divided edge between two vertices; null where no cut crosses it.
  const DividedEdge<D>* find(std::int32_t a, std::int32_t b) const;

  /// [vertex] the first vertex of its part. The edges that no cut crosses join the vertices of a
  /// simplex, or of one of its facets, into parts.
  template <std::size_t N>
  std::array<std::int32_t, N> parts(const std::array<std::int32_t, N>& vertices) const {
    std::array<std::int32_t, N> part = vertices;
    // A longest path through N vertices has N - 1 edges.
    for (std::size_t sweep = 0; sweep + 1 < N; ++sweep) {
      for (std::size_t i = 0; i < N; ++i) {
        for (std::size_t j = 0; j < N; ++j) {
          if (part[j] < part[i] && !find(vertices[i], vertices[j])) part[i] = part[j];
        }
      }
    }
    return part;
  }

 private:
  using Edge = std::array<std::int32_t, 2>;  ///< the smaller number first
  std::map<Edge, DividedEdge<D>> edges_;
};

extern template class DividedEdges<2>;
extern template class DividedEdges<3>;

}  // namespace pliant::point_based

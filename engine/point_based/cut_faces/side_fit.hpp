#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "engine/point_based/bonds/nearest_nodes.hpp"
#include "engine/point_based/cut_faces/cut_pieces.hpp"
#include "engine/point_based/cut_faces/divided_surface.hpp"
#include "engine/point_based/cutting/cut_front.hpp"
#include "engine/undeformed/contact/carried_points.hpp"

namespace pliant::point_based {

/// The nodes of an undeformed body.
template <int D>
struct NodePlaces {
  template <class T>
  explicit NodePlaces(const Body<T, D>& body);

  std::vector<std::int32_t> slot;  ///< [node]
  std::vector<double> size;        ///< [node] V^(1/D) [m]
  std::vector<Point<D>> start;     ///< [node] [m]
  NearestNodes<D> tree;
};

/// (PB.32): the nodes, with weights, that the vertices of a divided surface move with, from a
/// linear fit to the nodes near a vertex that no cut separates from it. Near the front of a cut,
/// nodes beyond the cut count too, (PB.33), so that its faces join there.
///
/// Displacements that are linear over the nodes of one side are reproduced at its vertices.
template <int D>
class SideFit {
 public:
  /// Keeps references. `fronts` are the fronts of the cuts.
  SideFit(const NodePlaces<D>& nodes, const Simplices<D>& body, const CutPieces<D>& pieces,
          const std::vector<CutFront<D>>& fronts)
      : nodes_(nodes), body_(body), pieces_(pieces), fronts_(fronts) {}

  /// Adds the shares of a vertex.
  void add(const SurfaceVertex<D>& vertex, std::vector<undeformed::Share>& shares);

 private:
  /// The nodes near `x` that no cut, except number `but`, separates from the vertex `side` of the
  /// simplices.
  std::vector<std::int32_t> nodes_near(const Point<D>& x, std::int32_t side,
                                       std::int32_t but) const;
  /// Adds `part` times the weights of a fit at `x` to the nearest of `nodes`.
  void add_fit(const Point<D>& x, std::vector<std::int32_t> nodes, double part,
               std::vector<undeformed::Share>& shares) const;

  const NodePlaces<D>& nodes_;
  const Simplices<D>& body_;
  const CutPieces<D>& pieces_;
  const std::vector<CutFront<D>>& fronts_;
  std::map<std::int32_t, std::vector<std::int32_t>> beside_;  ///< [vertex of the simplices]
};

extern template class SideFit<2>;
extern template class SideFit<3>;

}  // namespace pliant::point_based

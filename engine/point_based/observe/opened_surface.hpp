#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/point_based/cut_faces/side_fit.hpp"

namespace pliant::point_based {

/// Vertices and pieces of the surface of a frame while it is assembled.
struct SurfaceVertices {
  std::vector<double> position;                ///< [vertex][3] [m]
  std::vector<double> displacement, velocity;  ///< [vertex][axis] [m], [m/s]
  std::vector<std::int32_t> owner;             ///< [vertex] body
  std::vector<std::int64_t> vertex;            ///< [piece][corner]
};

/// The closed surface of a body with cuts. It includes both faces of each cut, which are separate
/// and join at its front.
///
/// The undeformed places of its vertices, and the nodes that they move with, depend on the cuts
/// alone. They are computed on the first query after a cut has grown; otherwise the surface is a
/// weighted sum over nodes.
template <int D>
class OpenedSurface {
 public:
  /// `spacing` [m] is that of the lattice of the surface; unused if the body is a mesh.
  template <class T>
  OpenedSurface(const Body<T, D>& body, double spacing, InsideTest<D> is_inside);

  /// Updates the surface for cuts that have grown.
  void follow(std::span<const CutSurface<D>> cuts);

  /// Adds the present surface.
  template <class T>
  void add(const Body<T, D>& body, int owner, SurfaceVertices& vertices) const;

  const DividedSurface<D>& undeformed() const { return surface_; }
  /// The nodes that vertex v moves with.
  std::span<const undeformed::Share> shares(std::size_t v) const {
    return {shares_.data() + first_share_[v], shares_.data() + first_share_[v + 1]};
  }

 private:
  double spacing_, size_;  ///< size_: H [m]
  InsideTest<D> is_inside_;
  std::vector<std::array<std::int32_t, D>> facets_;  ///< of the surface without cuts
  std::int32_t corners_;
  BodySimplices<D> simplices_;
  NodePlaces<D> nodes_;
  std::size_t pieces_ = 0;  ///< pieces of cuts considered so far
  DividedSurface<D> surface_;
  std::vector<std::size_t> first_share_;  ///< [vertex + 1]
  std::vector<undeformed::Share> shares_;
};

extern template class OpenedSurface<2>;
extern template class OpenedSurface<3>;

}  // namespace pliant::point_based

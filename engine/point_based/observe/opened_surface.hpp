#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/point_based/cut_faces/side_fit.hpp"

namespace pliant::point_based {

/// Vertices and pieces of the surface of a frame while it is put together.
struct SurfaceVertices {
  std::vector<double> position;                ///< [vertex][3] [m]
  std::vector<double> displacement, velocity;  ///< [vertex][axis] [m], [m/s]
  std::vector<std::int32_t> owner;             ///< [vertex] body
  std::vector<std::int64_t> vertex;            ///< [piece][corner]
};

/// The surface of a body with cuts, both faces of each cut included: closed, with the faces of a
/// cut apart, and joined at its front.
///
/// Where its vertices are in the undeformed body, and which nodes they move with, follow from the
/// cuts alone. They are found when the surface is first asked for after a cut has grown; in between
/// the surface is a weighted sum over nodes.
template <int D>
class OpenedSurface {
 public:
  /// `spacing` is that of the lattice of the surface [m], where the body is no mesh.
  template <class T>
  OpenedSurface(const Body<T, D>& body, double spacing, InsideTest<D> is_inside);

  /// Follows cuts that have grown.
  void follow(std::span<const CutSurface<D>> cuts);

  /// Adds the present surface.
  template <class T>
  void add(const Body<T, D>& body, int owner, SurfaceVertices& vertices) const;

  const DividedSurface<D>& undeformed() const { return surface_; }
  /// What vertex v moves with.
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
  std::size_t pieces_ = 0;  ///< of cuts that it has followed
  DividedSurface<D> surface_;
  std::vector<std::size_t> first_share_;  ///< [vertex + 1]
  std::vector<undeformed::Share> shares_;
};

extern template class OpenedSurface<2>;
extern template class OpenedSurface<3>;

}  // namespace pliant::point_based

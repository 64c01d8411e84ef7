#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/boundaries/walls.hpp"
#include "engine/remeshed/lattice_view.hpp"

namespace pliant::remeshed {

/// A vertex of the free surface, on a line between two nodes.
template <int D>
struct SurfaceVertex {
  Point<D> place;        ///< [m]
  std::int64_t inside;   ///< slot of the node inside the body
  std::int64_t outside;  ///< slot of the other
  double fraction;       ///< of the way from the first to the second

  /// A field on nodes, linear between the two.
  template <class T>
  double interpolated(const T* field) const {
    return field[inside] + fraction * (field[outside] - field[inside]);
  }
};

/// Segments in 2D, with the body to their left; triangles in 3D, anticlockwise from outside.
template <int D>
struct ExtractedSurface {
  std::vector<SurfaceVertex<D>> vertices;
  std::vector<std::array<std::int64_t, D>> pieces;  ///< of vertices
};

/// The free surface {phi = 0} of a body in front of every wall, each vertex once.
///
/// Vertices and pieces come in the order of the slots. The surface of a body that neither meets a
/// wall nor repeats itself is closed.
template <class T, int D>
ExtractedSurface<D> surface_mesh(const LatticeView<T, D>& view, const Boundaries<D>& boundaries);

}  // namespace pliant::remeshed

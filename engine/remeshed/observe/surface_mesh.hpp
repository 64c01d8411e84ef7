#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/boundaries/walls.hpp"
#include "engine/remeshed/state/lattice_view.hpp"

namespace pliant::remeshed {

/// A vertex of the surface, on a line between two nodes.
template <int D>
struct SurfaceVertex {
  Point<D> place;        ///< [m]
  std::int64_t inside;   ///< slot of the node inside the body
  std::int64_t outside;  ///< slot of the node outside it
  double fraction;       ///< share of the way from `inside` to `outside`

  /// A field on nodes, interpolated linearly.
  template <class T>
  double interpolated(const T* field) const {
    return field[inside] + fraction * (field[outside] - field[inside]);
  }
};

/// Segments with the body to their left in 2D; triangles in 3D, anticlockwise from outside.
template <int D>
struct ExtractedSurface {
  std::vector<SurfaceVertex<D>> vertices;
  std::vector<std::array<std::int64_t, D>> pieces;  ///< as vertices
};

/// The closed surface of a body, each vertex once: free parts, parts at walls that hold it or are
/// in contact with it, and the ends of its period.
///
/// Vertices and pieces are in the order of the slots.
template <class T, int D>
ExtractedSurface<D> surface_mesh(const LatticeView<T, D>& view, const Boundaries<D>& boundaries);

}  // namespace pliant::remeshed

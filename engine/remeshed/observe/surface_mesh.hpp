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

/// The closed surface of a body, each vertex once: where it is free, where walls hold it or are in
/// contact with it, and at the ends of its period.
///
/// Vertices and pieces come in the order of the slots.
template <class T, int D>
ExtractedSurface<D> surface_mesh(const LatticeView<T, D>& view, const Boundaries<D>& boundaries);

}  // namespace pliant::remeshed

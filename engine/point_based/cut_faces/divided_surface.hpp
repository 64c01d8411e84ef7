#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/point_based/cut_faces/body_simplices.hpp"
#include "engine/point_based/cut_faces/cut_pieces.hpp"

// The surface of a body with cuts, their faces included, in the undeformed body.
//
//       a       a          A cut separates vertices of the simplices that fill the body: it crosses
//      / \     / \         the edges between them. In each simplex its faces run between the points
//     x---x   x-. \        of the cut on these edges. Where a cut ends in a facet, or cuts meet in
//    /     \ /   . \       one, there is a point of the cut inside the facet. Each point exists
//   b-------b-------b      once for each part into which the cut divides its edge, facet, or
//                          simplex: so the faces of a cut are separate, and joined at its front.
//
// What is joined follows from which edges are crossed alone, whatever the cuts look like. So the
// surface is closed, and both faces of a cut have the same shape.
namespace pliant::point_based {

/// A vertex of such a surface.
template <int D>
struct SurfaceVertex {
  Point<D> place;                  ///< undeformed [m]
  std::int32_t side;               ///< vertex of the simplices on the same side of the cuts
  std::vector<std::int32_t> cuts;  ///< on which it lies
};

/// A closed surface: segments in 2D, triangles in 3D.
template <int D>
struct DividedSurface {
  std::vector<SurfaceVertex<D>> vertices;           ///< first those of the undivided surface
  std::vector<std::array<std::int32_t, D>> facets;  ///< seen from outside
};

/// Divides the surface of a body with these `corners` first among the vertices of its simplices,
/// and adds the faces of the cuts. `body` has all simplices that cuts cross.
template <int D>
DividedSurface<D> divide_surface(const Simplices<D>& body, std::int32_t corners,
                                 const std::vector<std::array<std::int32_t, D>>& facets,
                                 const CutPieces<D>& pieces);

}  // namespace pliant::point_based

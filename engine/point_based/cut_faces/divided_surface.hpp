#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/point_based/cut_faces/body_simplices.hpp"
#include "engine/point_based/cut_faces/cut_pieces.hpp"

// The surface of a body with cuts, including the faces of the cuts, in the undeformed body.
//
//      a       a          A cut crosses edges of the simplices that fill the body, and so
//     / \     / \         separates their vertices. In each simplex, the faces of the cut span the
//    x---x   x-. \        points where it crosses these edges. Where a cut ends in a facet, or cuts
//   /     \ /   . \       meet in it, the facet has an inner point. Each point exists once for each
//  b-------b-------b      part into which the cut divides its edge, facet, or simplex. So the faces
//                         of a cut are separate, and joined only at its front.
//
// The topology depends only on which edges are crossed, not on the shape of the cuts. So the
// surface is closed, and both faces of a cut have the same shape.
namespace pliant::point_based {

/// A vertex of the divided surface.
template <int D>
struct SurfaceVertex {
  Point<D> place;                  ///< undeformed [m]
  std::int32_t side;               ///< a vertex of the simplices on the same side of the cuts
  std::vector<std::int32_t> cuts;  ///< the cuts on which it lies
};

/// A closed surface: segments in 2D, triangles in 3D.
template <int D>
struct DividedSurface {
  std::vector<SurfaceVertex<D>> vertices;  ///< the first ones are those of the undivided surface
  std::vector<std::array<std::int32_t, D>> facets;  ///< vertices, ordered as seen from outside
};

/// Divides the surface of a body and adds the faces of the cuts. The `corners` of the surface are
/// the first vertices of `body`, which has all simplices that cuts cross.
template <int D>
DividedSurface<D> divide_surface(const Simplices<D>& body, std::int32_t corners,
                                 const std::vector<std::array<std::int32_t, D>>& facets,
                                 const CutPieces<D>& pieces);

}  // namespace pliant::point_based

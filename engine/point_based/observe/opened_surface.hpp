#pragma once

#include <span>

#include "engine/point_based/body.hpp"
#include "engine/point_based/cutting/cut_surface.hpp"

namespace pliant::point_based {

/// Vertices and pieces of the surface of a frame while it is put together.
struct SurfaceVertices {
  std::vector<double> position;                ///< [vertex][3] [m]
  std::vector<double> displacement, velocity;  ///< [vertex][axis] [m], [m/s]
  std::vector<std::int32_t> owner;             ///< [vertex] body
  std::vector<std::int64_t> vertex;            ///< [piece][corner]
};

/// Adds the present surface of a body with cuts, both faces of each cut included, in separate
/// pieces. A piece moves with the nodes near it that are on its side of the cuts, so that the faces
/// of a cut come apart.
template <class T, int D>
void add_opened_surface(const Body<T, D>& body, std::span<const CutSurface<D>> cuts, int owner,
                        SurfaceVertices& vertices);

}  // namespace pliant::point_based

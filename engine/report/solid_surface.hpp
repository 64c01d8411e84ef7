#pragma once

#include <cstdint>
#include <vector>

#include "engine/blocks/box.hpp"
#include "engine/geometry/shape.hpp"

namespace pliant::report {

struct TriangleMesh {
  std::vector<Vector> vertex;           ///< [m]
  std::vector<std::uint32_t> triangle;  ///< three vertices each, anticlockwise as seen from outside
};

/// The surface of a solid in 3D inside a box, closed at the end of the box. Edges and corners are
/// sharp: each cell of a sampling lattice has one vertex, where the tangent planes at the points at
/// which the surface crosses the edges of the cell meet (Ju, Losasso, Schaefer & Warren, Dual
/// contouring of Hermite data, 2002).
TriangleMesh surface_of_solid(const Shape& solid, const Box<3>& box);

double longest_side(const Box<3>& box);

}  // namespace pliant::report

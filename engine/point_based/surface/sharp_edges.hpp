#pragma once

#include "engine/geometry/shape.hpp"
#include "engine/point_based/body.hpp"

namespace pliant::point_based {

/// Moves corners of facets onto the edges and corners of `shape`, so that no facet cuts them off,
/// (PB.69), where its faces are planes. Corners off the faces, and those farther away than the
/// spacing, stay.
template <int D>
void sharpen_edges(const Shape& shape, BodySurface<D>& surface);

extern template void sharpen_edges<2>(const Shape&, BodySurface<2>&);
extern template void sharpen_edges<3>(const Shape&, BodySurface<3>&);

}  // namespace pliant::point_based

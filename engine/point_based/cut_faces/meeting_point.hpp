#pragma once

#include <span>

#include "engine/point_based/cut_faces/cut_pieces.hpp"
#include "engine/point_based/cutting/column.hpp"

namespace pliant::point_based {

/// (PB.31): the place nearest to the mean of crossings of one or more cuts that lies on the planes
/// of all of them, in the sense of least squares, and away from that mean in directions normal to
/// `held` only, which span the normals of the body's surface there. Directions in which the planes
/// say little do not count; nor do places farther than `reach` [m] from the mean, where it is the
/// mean.
template <int D>
Column<D> meeting_point(std::span<const typename CutPieces<D>::Crossed> crossings,
                        std::span<const Column<D>> held, double reach);

}  // namespace pliant::point_based

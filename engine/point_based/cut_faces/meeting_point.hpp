#pragma once

#include <span>

#include "engine/lattice/column.hpp"
#include "engine/point_based/cut_faces/cut_pieces.hpp"

namespace pliant::point_based {

/// (PB.31): the point on the planes of all `crossings`, of one or more cuts, in the least-squares
/// sense, nearest to their mean. It leaves the mean only in directions normal to `held`, which span
/// the normals of the body's surface there. Directions that the planes hardly determine are left
/// out. Returns the mean if the point is farther than `reach` [m] from it.
template <int D>
Column<D> meeting_point(std::span<const typename CutPieces<D>::Crossed> crossings,
                        std::span<const Column<D>> held, double reach);

}  // namespace pliant::point_based

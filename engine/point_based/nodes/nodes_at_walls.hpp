#pragma once

#include <optional>

#include "engine/boundaries/walls.hpp"
#include "engine/geometry/shape.hpp"
#include "engine/point_based/nodes/node_cloud.hpp"

namespace pliant::point_based {

/// [node] what of its volume lies outside the walls that material sticks to [m^D], (PB.21). Where
/// the nodes have a `pitch` [m], those of a lattice within half of it of the surface of an attached
/// wall move onto it: the body is held where the wall is, not at the nearest lattice point.
template <int D>
std::vector<double> fit_to_walls(const Boundaries<D>& boundaries, const Shape& shape,
                                 const std::optional<Point<D>>& pitch, NodeCloud<D>& cloud);

extern template std::vector<double> fit_to_walls<2>(const Boundaries<2>&, const Shape&,
                                                    const std::optional<Point<2>>&, NodeCloud<2>&);
extern template std::vector<double> fit_to_walls<3>(const Boundaries<3>&, const Shape&,
                                                    const std::optional<Point<3>>&, NodeCloud<3>&);

}  // namespace pliant::point_based

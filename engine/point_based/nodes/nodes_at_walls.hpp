#pragma once

#include <optional>

#include "engine/boundaries/walls.hpp"
#include "engine/geometry/shape.hpp"
#include "engine/point_based/nodes/node_cloud.hpp"

namespace pliant::point_based {

/// [node] what of its volume lies outside the walls that material sticks to [m^D], (PB.21). Nodes
/// that no mesh gives move onto the surface of an attached wall within half of their distance: the
/// body is held where the wall is, not at the nearest node. `pitch` [m] is that of a lattice; nodes
/// without one, and those of large cells, are as far apart as their volumes say.
template <int D>
std::vector<double> fit_to_walls(const Boundaries<D>& boundaries, const Shape& shape,
                                 const std::optional<Point<D>>& pitch, NodeCloud<D>& cloud);

extern template std::vector<double> fit_to_walls<2>(const Boundaries<2>&, const Shape&,
                                                    const std::optional<Point<2>>&, NodeCloud<2>&);
extern template std::vector<double> fit_to_walls<3>(const Boundaries<3>&, const Shape&,
                                                    const std::optional<Point<3>>&, NodeCloud<3>&);

}  // namespace pliant::point_based

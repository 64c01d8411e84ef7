#pragma once

#include <optional>

#include "engine/boundaries/walls.hpp"
#include "engine/geometry/shape.hpp"
#include "engine/point_based/nodes/node_cloud.hpp"

namespace pliant::point_based {

/// [node] the elastic volume: the part of its volume outside no-slip walls [m^D], (PB.21). For
/// nodes that no mesh gives: they move onto an attached wall within half of their spacing, so that
/// the body is held where the wall is and not at the nearest node. `pitch` [m] is that of a
/// lattice; for other nodes and those of large cells, the spacing follows from their volumes.
template <int D>
std::vector<double> fit_to_walls(const Boundaries<D>& boundaries, const Shape& shape,
                                 const std::optional<Point<D>>& pitch, NodeCloud<D>& cloud);

extern template std::vector<double> fit_to_walls<2>(const Boundaries<2>&, const Shape&,
                                                    const std::optional<Point<2>>&, NodeCloud<2>&);
extern template std::vector<double> fit_to_walls<3>(const Boundaries<3>&, const Shape&,
                                                    const std::optional<Point<3>>&, NodeCloud<3>&);

/// [node] the volume of the elements of a mesh at each node, without those that no-slip walls hold
/// at all corners, as they cannot deform [m^D]. Walls hold the nodes that are nearer than `reach`
/// [m].
template <int D>
std::vector<double> volumes_of_free_elements(const Boundaries<D>& boundaries,
                                             const std::vector<double>& reach,
                                             const NodeCloud<D>& cloud);

extern template std::vector<double> volumes_of_free_elements<2>(const Boundaries<2>&,
                                                                const std::vector<double>&,
                                                                const NodeCloud<2>&);
extern template std::vector<double> volumes_of_free_elements<3>(const Boundaries<3>&,
                                                                const std::vector<double>&,
                                                                const NodeCloud<3>&);

}  // namespace pliant::point_based

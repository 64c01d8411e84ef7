#pragma once

#include "engine/case/case.hpp"
#include "engine/point_based/body.hpp"
#include "engine/point_based/bonds/bonds.hpp"
#include "engine/point_based/nodes/place_nodes.hpp"
#include "scheduler/workers.hpp"

namespace pliant::point_based {

/// The neighbours of the nodes of a body, nearest first, and of bodies that blades cut those that
/// may replace them. Throws InputError if nodes have too few or lie at one place.
template <class T, int D>
BondChoice<D> choose_neighbours(const Case& settings, const PlacedNodes<D>& nodes,
                                const Body<T, D>& body, scheduler::Workers& workers);

}  // namespace pliant::point_based

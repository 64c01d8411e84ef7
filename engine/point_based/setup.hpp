#pragma once

#include "engine/point_based/bonds/bonds.hpp"
#include "engine/point_based/nodes/place_nodes.hpp"
#include "engine/point_based/state.hpp"
#include "scheduler/workers.hpp"

namespace pliant::point_based {

/// What applies pressures: the kernel that evaluates the bonds, or NodeLoads.
enum class PressureForces { of_bonds, of_loads };

/// All of make_body except the bonds.
template <class T, int D>
void make_nodes(const Case& settings, const BodyCase& source, const PlacedNodes<D>& nodes,
                const Boundaries<D>& boundaries, PressureForces pressures, Body<T, D>& body);

/// Makes a body of a case from its nodes, at rest or with the initial velocity of the case. Throws
/// InputError for nodes that do not form a body. Returns how nodes have chosen their neighbours.
template <class T, int D>
BondChoice<D> make_body(const Case& settings, const BodyCase& source, const PlacedNodes<D>& nodes,
                        const Boundaries<D>& boundaries, scheduler::Workers& workers,
                        Body<T, D>& body);

/// Numbers the blocks of all bodies. Returns which blocks are neighbours.
template <class T, int D>
scheduler::Blocks number_blocks(State<T, D>& state);

}  // namespace pliant::point_based

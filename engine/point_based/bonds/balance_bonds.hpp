#pragma once

#include "engine/boundaries/walls.hpp"
#include "engine/point_based/bonds/bonds.hpp"
#include "scheduler/workers.hpp"

namespace pliant::point_based {

/// Corrects the weights of the bonds of a body with irregular nodes so that a uniform stress exerts
/// little force on nodes that no wall holds, (PB.61).
template <class T, int D>
void balance_bonds(const NodeCloud<D>& cloud, const Body<T, D>& body,
                   const Boundaries<D>& boundaries, BondChoice<D>& choice,
                   scheduler::Workers& workers);

}  // namespace pliant::point_based

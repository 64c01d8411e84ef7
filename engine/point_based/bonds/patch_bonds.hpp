#pragma once

#include "engine/point_based/bonds/bonds.hpp"
#include "scheduler/workers.hpp"

namespace pliant::point_based {

/// Corrects the weights of the bonds of a body so that its gradients pass the patch test, (PB.17).
/// Throws InputError if surface nodes are not on the surface of the body, or if no weights pass the
/// test.
template <class T, int D>
void correct_weights(const NodeCloud<D>& cloud, const Body<T, D>& body, BondChoice<D>& choice,
                     scheduler::Workers& workers);

}  // namespace pliant::point_based

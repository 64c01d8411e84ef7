#pragma once

#include "engine/point_based/bonds/bonds.hpp"

namespace pliant::point_based {

/// Corrects the weights of the bonds of a body so that its gradients pass the patch test, (PB.17).
/// Throws InputError for nodes that do not lie on the surface of the body, and where no weights
/// pass it.
template <class T, int D>
void correct_weights(const NodeCloud<D>& cloud, const Body<T, D>& body, BondChoice<D>& choice);

/// Corrects the weights of the bonds of a body of irregular nodes so that a uniform stress exerts
/// little force on nodes inside, (PB.61).
template <class T, int D>
void balance_bonds(const NodeCloud<D>& cloud, const Body<T, D>& body, BondChoice<D>& choice);

}  // namespace pliant::point_based

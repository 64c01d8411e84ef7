#pragma once

#include "engine/remeshed/state/body.hpp"

/// Where the force of a traction acts on the particles behind it, (RP.107), the stress that
/// balances it rises below the surface. That of the material does not: the difference is (RP.112).
namespace pliant::remeshed {

/// Takes the difference from the stress of the particles of a block at a stage, after
/// `evaluate_shear`; what is left balances the forces.
template <class T, int D>
void take_shear_stress(Body<T, D>& body, int block, int stage);

/// Gives it back at the first stage, to the last bit.
template <class T, int D>
void give_back_shear_stress(Body<T, D>& body, int block);

}  // namespace pliant::remeshed

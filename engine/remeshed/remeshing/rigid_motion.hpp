#pragma once

#include "engine/remeshed/observe/motion_integrals.hpp"

/// The rigid motion nearest to the motion of a body, from its integrals (RP.42), (RP.70).
namespace pliant::remeshed {

/// Sum of the integrals of two parts of a body.
void add(MotionIntegrals& sum, const MotionIntegrals& other);

/// [m]
Vector mass_centre(const MotionIntegrals& motion);

/// Angular momentum about the mass centre [N m s].
Vector spin_of(const MotionIntegrals& motion);

/// Angular velocity of a rigid body with the inertia of `motion` and this spin [1/s]: I^-1 L with I
/// = tr(S) 1 - S, where S are the second moments about the mass centre; in 2D about z only.
template <int D>
Vector angular_velocity(const MotionIntegrals& motion, const Vector& spin);

}  // namespace pliant::remeshed

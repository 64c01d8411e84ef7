#pragma once

#include "engine/case/case.hpp"

namespace pliant {

/// Velocity of a body's material at `x` at t = 0 [m/s].
Vector initial_velocity(const BodyCase& body, const Vector& x);

}  // namespace pliant

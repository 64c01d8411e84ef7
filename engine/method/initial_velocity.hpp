#pragma once

#include <string>
#include <vector>

#include "engine/case/case.hpp"

namespace pliant {

/// Velocity of a body's material at `x` at t = 0 [m/s].
Vector initial_velocity(const BodyCase& body, const Vector& x);

/// The factor c of (TL.34).
struct ExcessOfEnergy {
  double boxes, others;
};

/// Adds a warning for each body that starts with more than 2 % too much or too little kinetic
/// energy, (TL.34).
void warn_of_initial_motion(const Case& a_case, const ExcessOfEnergy& excess,
                            std::vector<std::string>& warnings);

}  // namespace pliant

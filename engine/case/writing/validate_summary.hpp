#pragma once

#include <optional>
#include <string>

#include "engine/case/case.hpp"

namespace pliant {

/// What a valid case would run, in a few lines for people: bodies, boundaries, particles, time
/// steps, measurements. Particle numbers and steps are estimates, unless the time step of a set-up
/// is given [s]: then steps are counted with it, and particles are left to the set-up.
std::string validate_summary(const Case& a_case, std::optional<double> step_of_setup = {});

}  // namespace pliant

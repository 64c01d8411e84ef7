#pragma once

#include <optional>
#include <string>

#include "engine/case/case.hpp"

namespace pliant {

/// A valid case in a few lines for users: bodies, boundaries, particles, time steps, measurements.
/// Numbers of particles and steps are estimates. With the time step of a set-up [s], steps follow
/// from it, and the set-up reports particles.
std::string validate_summary(const Case& a_case, std::optional<double> step_of_setup = {});

}  // namespace pliant

#pragma once

#include <string>

#include "engine/case/case.hpp"

namespace pliant {

/// What a valid case would run, in a few lines for people: bodies, boundaries, particles, time
/// steps, measurements. Particle numbers and steps are estimates.
std::string validate_summary(const Case& a_case);

}  // namespace pliant

#pragma once

#include <string_view>

#include "engine/case/checks/check.hpp"

namespace pliant {

/// Refuses a displacement that is not zero at `time`, when the motion starts. Messages call what
/// moves `subject`.
void check_start_of_motion(const Check& check, const Place& place, std::string_view subject,
                           const VectorExpression& displacement, double time);

}  // namespace pliant

#pragma once

#include <string_view>

#include "engine/case/check.hpp"

namespace pliant {

/// Whether a displacement is zero at `time`, when what it moves starts; `subject` names that. Adds
/// what is wrong.
bool starts_in_place(const Check& check, const Place& place, std::string_view subject,
                     const VectorExpression& displacement, double time);

}  // namespace pliant

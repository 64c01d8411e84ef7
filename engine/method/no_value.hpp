#pragma once

#include <limits>

namespace pliant {

/// What a measurement is where it has no meaning: NaN, an empty cell in tables.
inline constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

}  // namespace pliant

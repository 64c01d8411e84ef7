#pragma once

#include <limits>

namespace pliant {

/// The value of a measurement that has no meaning at present: NaN, an empty cell in tables.
inline constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

}  // namespace pliant

#pragma once

#include <vector>

#include "engine/case/case.hpp"

namespace pliant::remeshed {

/// The boundaries of a case, with walls that are deep and wide enough for the ghosts behind them: a
/// box grows on the side away from the bodies, and, if it holds bodies, beside the edges of the
/// face that it covers.
std::vector<BoundaryCase> with_deep_walls(const Case& settings);

/// Whether a box is too thin for the ghosts behind it, and cannot grow, as there are bodies on both
/// sides.
bool is_too_thin(const Case& settings, const BoundaryCase& wall);

}  // namespace pliant::remeshed

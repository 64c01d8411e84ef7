#pragma once

#include <span>

namespace pliant {

// The level about which a history oscillates follows from its extrema; it need not be zero.
// Deviations of less than a tenth of the largest one are not part of the oscillation.

/// Period: twice the mean time between crossings of the level (linear between samples); NaN with
/// fewer than two.
double oscillation_period(std::span<const double> time, std::span<const double> value);

/// Mean ratio of successive extrema on the same side of the level, each relative to the level: the
/// largest deviation of a sample between two crossings, refined by a parabola; NaN when no side has
/// two.
double amplitude_ratio(std::span<const double> time, std::span<const double> value);

}  // namespace pliant

#pragma once

#include <span>

namespace pliant {

/// Period of an oscillation about zero: twice the mean spacing of its zero crossings (linear
/// between samples); NaN with fewer than two.
double oscillation_period(std::span<const double> time, std::span<const double> value);

/// Mean ratio of successive extrema of the same sign, each the largest sample between two
/// crossings, refined by a parabola; NaN when no sign has two.
double amplitude_ratio(std::span<const double> time, std::span<const double> value);

}  // namespace pliant

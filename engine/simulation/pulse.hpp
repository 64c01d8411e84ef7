#pragma once

#include <span>

/// What is left of a pulse: a signal that rises and is over, as the force of a contact. Each value
/// is a mean since the sample before, so that values times their intervals are exact integrals.
namespace pliant {

/// (RP.62): largest mean of the signal over `duration` [s], by the samples' ends; NaN while the
/// samples are shorter.
double peak_moving_average(std::span<const double> time, std::span<const double> value,
                           double duration);

/// (RP.63): end of the last sample above a thousandth of the largest; NaN while none is positive.
double last_time_above(std::span<const double> time, std::span<const double> value);

}  // namespace pliant

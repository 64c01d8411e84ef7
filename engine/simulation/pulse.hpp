#pragma once

#include <span>

/// What remains of a pulse: a signal of either sign that rises and is over, as the force of a
/// contact. Each value is a mean since the sample before, so that values times their intervals are
/// exact integrals.
namespace pliant {

/// (RP.66): moving average over `duration` [s], by the ends of the samples, where its magnitude is
/// largest; with its sign. NaN while the samples cover less than the duration.
double peak_moving_average(std::span<const double> time, std::span<const double> value,
                           double duration);

/// (RP.67): end of the last sample whose magnitude exceeds `fraction` of the largest magnitude; NaN
/// while all are zero.
double last_time_above(std::span<const double> time, std::span<const double> value,
                       double fraction);

}  // namespace pliant

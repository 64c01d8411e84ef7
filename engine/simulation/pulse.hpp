#pragma once

#include <span>

/// Characteristics of a pulse: a signal of either sign that rises and decays, such as a contact
/// force. Each value is a mean since the previous sample, so values times intervals are exact
/// integrals.
namespace pliant {

/// (RP.66): the moving average over `duration` [s] at the sample where its magnitude is largest,
/// with its sign. NaN while the samples cover less than the duration.
double peak_moving_average(std::span<const double> time, std::span<const double> value,
                           double duration);

/// (RP.67): end of the last sample whose magnitude exceeds `fraction` of the largest one; NaN while
/// all are zero.
double last_time_above(std::span<const double> time, std::span<const double> value,
                       double fraction);

}  // namespace pliant

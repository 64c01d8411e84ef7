#pragma once

#include <array>

/// The stages s = 0..3 of a step, (RP.21).
namespace pliant::remeshed {

/// Times of the state that a stage reads and of the state that it writes, in time steps.
inline constexpr std::array<double, 4> stage_time = {0, 0.5, 0.5, 1};
inline constexpr std::array<double, 4> stage_end = {0.5, 0.5, 1, 1};
/// Weight of the rates of a stage in the step.
inline constexpr std::array<double, 4> stage_weight = {1. / 6, 1. / 3, 1. / 3, 1. / 6};

/// Time steps by which a stage advances with its rates: from the state before the step, or, in the
/// last stage, from the sum that the earlier stages have left.
inline constexpr std::array<double, 4> stage_share = {0.5, 0.5, 1, 1. / 6};

/// The buffer of the state that a stage reads, and of the one that it writes: Q4 takes the place of
/// Q2.
constexpr int buffer_of(int stage) { return stage == 3 ? 1 : stage; }
constexpr int buffer_after(int stage) { return buffer_of((stage + 1) % 4); }

/// The same for the drift, where Q3 takes the place of Q0.
constexpr int drift_buffer_of(int stage) { return stage % 2; }
constexpr int drift_buffer_after(int stage) { return drift_buffer_of(stage + 1); }

}  // namespace pliant::remeshed

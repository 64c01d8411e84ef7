#pragma once

#include <array>

/// The stages s = 0..3 of a step, (RP.19).
namespace pliant::remeshed {

/// When the state of a stage is, and when the one that it leaves behind, in time steps.
inline constexpr std::array<double, 4> stage_time = {0, 0.5, 0.5, 1};
inline constexpr std::array<double, 4> stage_end = {0.5, 0.5, 1, 1};
/// What the rates of a stage count for in the step.
inline constexpr std::array<double, 4> stage_weight = {1. / 6, 1. / 3, 1. / 3, 1. / 6};

}  // namespace pliant::remeshed

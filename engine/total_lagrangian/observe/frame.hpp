#pragma once

#include "engine/output/results/frame.hpp"
#include "engine/total_lagrangian/state.hpp"

namespace pliant::total_lagrangian {

/// The particles of a state for viewers, in SI units. Stress, pressure and dilatation are means
/// over the stress points around a particle. There are no ghosts.
template <class T, int D>
Frame take_frame(const State<T, D>& state, const FrameParts& parts);

}  // namespace pliant::total_lagrangian

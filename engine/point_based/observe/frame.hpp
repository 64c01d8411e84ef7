#pragma once

#include "engine/output/results/frame.hpp"
#include "engine/point_based/state.hpp"

namespace pliant::point_based {

/// The nodes of a state for viewers, in SI units, and the surface with the faces of cuts. There are
/// no ghosts.
template <class T, int D>
Frame take_frame(const State<T, D>& state, const FrameParts& parts);

}  // namespace pliant::point_based

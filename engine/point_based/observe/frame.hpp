#pragma once

#include "engine/output/results/frame.hpp"
#include "engine/point_based/state.hpp"

namespace pliant::point_based {

/// The nodes of a state as viewers see them, in SI units, and the surface with the faces of cuts.
/// There are no ghosts to show.
template <class T, int D>
Frame take_frame(const State<T, D>& state, const FrameParts& parts);

}  // namespace pliant::point_based

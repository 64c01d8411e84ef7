#pragma once

#include <span>

#include "engine/output/frame.hpp"
#include "engine/point_based/cutting/cut_surface.hpp"
#include "engine/point_based/state.hpp"

namespace pliant::point_based {

/// The nodes of a state as viewers see them, in SI units, and the surface with the faces of the
/// cuts of each body. There are no ghosts to show.
template <class T, int D>
Frame take_frame(const State<T, D>& state, const FrameParts& parts,
                 std::span<const std::span<const CutSurface<D>>> cuts);

}  // namespace pliant::point_based

#pragma once

#include <span>

#include "engine/point_based/body.hpp"
#include "engine/point_based/cutting/cut_surface.hpp"

namespace pliant::point_based {

/// The undeformed place [m] of the tissue that is now at `x`: linear around the nearest node, X_i +
/// F_i^-1 (x - x_i). If `x` is in the gap of a cut, it is the place where the line from the node to
/// it crosses the cut.
template <class T, int D>
MaterialPoint<D> tissue_at(const Body<T, D>& body, std::span<const CutSurface<D>> cuts,
                           const Point<D>& x);

}  // namespace pliant::point_based

#pragma once

#include <span>

#include "engine/point_based/body.hpp"
#include "engine/point_based/cutting/cut_surface.hpp"

namespace pliant::point_based {

/// The place in the undeformed body [m] of the tissue that is at `x` at present: linear around the
/// node that is nearest to it now, X_i + F_i^-1 (x - x_i). Where there is no tissue any more, in
/// the gap of a cut, the place on that cut which is on the way there from the node.
template <class T, int D>
MaterialPoint<D> tissue_at(const Body<T, D>& body, std::span<const CutSurface<D>> cuts,
                           const Point<D>& x);

}  // namespace pliant::point_based

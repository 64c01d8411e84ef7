#pragma once

#include <functional>
#include <optional>

#include "engine/remeshed/state/lattice_view.hpp"

/// Where the free surface of a body lies: zeros of the level set on fresh nodes.
namespace pliant::remeshed {

/// Distance [m] from `origin` along the unit vector `direction` to the last zero of phi on the way
/// out of the body, of the points that `counts` admits (all, when empty); none when there is no
/// such point.
template <class T, int D>
std::optional<double> ray_to_surface(const LatticeView<T, D>& view, const Vector& origin,
                                     const Vector& direction,
                                     const std::function<bool(const Vector&)>& counts = {});

/// Farthest coordinate along `axis` (or, on the lower side, the lowest) that the surface reaches on
/// the node lines parallel to it, of the points that `counts` admits.
template <class T, int D>
std::optional<double> extent(const LatticeView<T, D>& view, int axis, bool lower_side,
                             const std::function<bool(const Vector&)>& counts);

}  // namespace pliant::remeshed

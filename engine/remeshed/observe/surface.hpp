#pragma once

#include <functional>
#include <optional>

#include "engine/remeshed/state/lattice_view.hpp"

/// The free surface of a body: zeros of the level set on new nodes.
namespace pliant::remeshed {

/// Distance [m] from `origin` along the unit vector `direction` to the last zero of phi on the way
/// out of the body. Only points that `counts` accepts are considered (all, if it is empty); none if
/// there is no such point.
template <class T, int D>
std::optional<double> ray_to_surface(const LatticeView<T, D>& view, const Vector& origin,
                                     const Vector& direction,
                                     const std::function<bool(const Vector&)>& counts = {});

/// Largest (or, on the lower side, smallest) coordinate along `axis` of the surface on node lines
/// parallel to it, of the points that `counts` accepts.
template <class T, int D>
std::optional<double> extent(const LatticeView<T, D>& view, int axis, bool lower_side,
                             const std::function<bool(const Vector&)>& counts);

}  // namespace pliant::remeshed

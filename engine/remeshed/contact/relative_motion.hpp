#pragma once

#include <vector>

#include "engine/remeshed/state/state.hpp"

// Whether ghosts still belong to where a body and what it touches are, (RP.96), (RP.108).
namespace pliant::remeshed {

/// Whether, since the last remeshing, a contact wall has moved, or the body towards contact walls
/// or away from them. `remeshed` holds the poses of the walls at that remeshing.
template <class T, int D>
bool has_moved_at_walls(const Body<T, D>& body, const Boundaries<D>& boundaries,
                        const std::vector<WallPose<D>>& remeshed);

/// Whether particles of two bodies near each other have moved by different displacements since the
/// last remeshing.
template <class T, int D>
bool have_moved_apart(const Body<T, D>& one, const Body<T, D>& other);

/// Whether parts of the surface of a body have moved by different displacements since the last
/// remeshing, over several rows of nodes.
template <class T, int D>
bool surface_has_crossed_rows(const Body<T, D>& body);

}  // namespace pliant::remeshed

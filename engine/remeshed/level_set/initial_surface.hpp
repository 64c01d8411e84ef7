#pragma once

#include "engine/remeshed/state/body.hpp"

namespace pliant::remeshed {

/// Moves phi at the nodes of one block near the surface towards the surface at t = 0, as
/// displacements give it, (RP.92). `fields` are those of the nodes; `valid` is 0 at nodes that
/// remeshing left empty.
template <class T, int D>
void recall_initial_surface(const Lattice<D>& lattice, const Layout<D>& layout, int block,
                            const Shape& initial_surface, const T* valid, FieldStore<T, D>& fields);

}  // namespace pliant::remeshed

#pragma once

#include "engine/boundaries/boundary_values.hpp"
#include "engine/lattice/surface_pieces.hpp"
#include "engine/remeshed/state/lattice_view.hpp"

namespace pliant::remeshed {

/// Finds the loaded facets of {phi = 0} of a block that are in front of attached walls. Slots must
/// be on nodes. A cube of slots belongs to the block of its first one; `surface` is the free
/// surface at t = 0.
template <class T, int D>
void find_loaded_facets(const LatticeView<T, D>& view, int block, const Shape& surface,
                        const Boundaries<D>& boundaries, std::vector<LoadedFacet<D>>& facets);

/// Sum of the loads on the facets of a block at a stage [N, in 2D N/m].
template <class T, int D>
PlaceVector<D> force_of_loads(const Body<T, D>& body, int block, int stage,
                              const BoundaryValues<D>& values);

/// Power of the loads on the facets of a block at a stage [W, in 2D W/m], (RP.72).
template <class T, int D>
double power_of_loads(const Body<T, D>& body, int block, int stage,
                      const BoundaryValues<D>& values);

}  // namespace pliant::remeshed

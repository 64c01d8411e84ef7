#pragma once

#include "engine/boundaries/boundary_values.hpp"
#include "engine/remeshed/state/lattice_view.hpp"

namespace pliant::remeshed {

/// Finds the loaded facets of {phi = 0} of a block that are in front of attached walls. Slots must
/// be on nodes. A cube of slots belongs to the block of its first one; `surface` is the free
/// surface at t = 0.
template <class T, int D>
void find_loaded_facets(const LatticeView<T, D>& view, int block, const Shape& surface,
                        const Boundaries<D>& boundaries, std::vector<LoadedFacet<D>>& facets);

/// The loads on the facets of a block at a stage, (RP.72).
template <int D>
struct LoadsOnBlock {
  Point<D> force = {};  ///< [N, in 2D N/m]
  double power = 0;     ///< [W, in 2D W/m]
};
template <class T, int D>
LoadsOnBlock<D> loads_on_block(const Body<T, D>& body, int block, int stage,
                               const BoundaryValues<D>& values);

}  // namespace pliant::remeshed

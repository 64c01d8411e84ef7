#pragma once

#include "engine/boundaries/boundary_values.hpp"
#include "engine/boundaries/wrench.hpp"
#include "engine/lattice/surface_pieces.hpp"
#include "engine/remeshed/state/lattice_view.hpp"

namespace pliant::remeshed {

/// Finds the loaded facets of {phi = 0} of a block that are in front of attached walls, and the
/// patches of those under tractions. Slots must be on nodes. A cube of slots belongs to the block
/// of its first one; `surface` is the free surface at t = 0.
template <class T, int D>
void find_loaded_facets(const LatticeView<T, D>& view, int block, const Shape& surface,
                        const Boundaries<D>& boundaries, std::vector<LoadedFacet<D>>& facets,
                        std::vector<ShearPatch<D>>& patches);

/// The load on a facet, and its part along the surface.
template <int D>
struct FacetForce {
  PlaceVector<D> whole, shear;  ///< [N, in 2D N/m]
  PlaceVector<D> place;         ///< of its middle [m]
};
template <class T, int D>
FacetForce<D> force_at_stage(const Body<T, D>& body, const LoadedFacet<D>& facet, int stage,
                             const BoundaryValues<D>& values);

/// The loads on the facets of a block at a stage, (RP.72).
template <int D>
struct LoadsOnBlock {
  Wrench<D> force;   ///< [N, N m, in 2D per m]
  double power = 0;  ///< [W, in 2D W/m]
};
template <class T, int D>
LoadsOnBlock<D> loads_on_block(const Body<T, D>& body, int block, int stage,
                               const BoundaryValues<D>& values);

}  // namespace pliant::remeshed

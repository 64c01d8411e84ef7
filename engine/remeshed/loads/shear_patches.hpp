#pragma once

#include "engine/boundaries/boundary_values.hpp"
#include "engine/remeshed/state/lattice_view.hpp"

/// The part of a traction along the surface acts on the particles behind it, (RP.107): near the
/// edges of a loaded face the shear stress of the surface jumps, which no ghost can follow.
namespace pliant::remeshed {

/// Finds the particles behind the patches of a block. Slots must be on nodes.
template <class T, int D>
void find_shear_shares(const LatticeView<T, D>& view, const Boundaries<D>& boundaries,
                       const std::vector<LoadedFacet<D>>& facets, BlockShear<D>& shear);

/// Lists the shares that the particles of a block have in the patches of the blocks around it.
template <class T, int D>
void list_shear_shares(Body<T, D>& body, const Layout<D>& layout, int block);

/// Evaluates the forces of the patches of a block at a stage.
template <class T, int D>
void evaluate_shear(Body<T, D>& body, int block, int stage, const BoundaryValues<D>& values);

/// Force on the particle of a share at the stage of the last `evaluate_shear` [N, in 2D N/m].
template <int D>
Point<D> shear_force(const ShearPatch<D>& patch, const ShearShare<D>& share) {
  Point<D> force = patch.mean;
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) force[i] += patch.turn[i * D + j] * share.offset[j];
    force[i] *= share.weight;
  }
  return force;
}

}  // namespace pliant::remeshed

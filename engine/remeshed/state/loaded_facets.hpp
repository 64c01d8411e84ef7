#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/lattice/lattice.hpp"
#include "kernels/layout.hpp"

/// Facets on which loads act, and the particles behind those under tractions.
namespace pliant::remeshed {

/// In place of the number of a load.
inline constexpr std::int8_t no_load = -1;

/// A corner of a facet. It lies between two slots and moves with them.
template <int D>
struct FacetCorner {
  std::int32_t inside, outside;  ///< slots
  double fraction;               ///< share of the way from the inside slot to the outside one
  Point<D> place;                ///< at xi = 0 [m]
};

/// The part of a facet that belongs to one face of the body.
template <int D>
struct FacetPart {
  std::int8_t load = no_load;
  double share = 1;      ///< of it on which the load acts
  Point<D> area = {};    ///< its area vector over the area of the facet
  Point<D> normal = {};  ///< of the face
};

/// A facet of {phi = 0} in its parts, as it is at a remeshing. One that cuts off an edge has a part
/// on each of the faces there.
template <int D>
struct FacetParts {
  Point<D> normal = {};  ///< of the facet
  int count = 0;
  std::array<FacetPart<D>, D> parts = {};
};

/// A facet on which a load acts; its normal points out of the body.
template <int D>
struct LoadedFacet {
  std::array<FacetCorner<D>, D> corners;
  double share;  ///< share in front of attached walls
  FacetParts<D> parts;
};

/// Facets in one cube of nodes that are under a traction; they share the particles behind them.
template <int D>
struct ShearPatch {
  /// Components of a moment.
  static constexpr int moments = D == 2 ? 1 : 3;

  std::int32_t first_facet = 0, facet_count = 0;
  std::array<Point<D>, D> axes = {};  ///< the outward normal, and unit vectors along the facets
  Point<D> lever = {};  ///< from the facets to the mean place of what is behind them [m]
  double material = 0;  ///< W of (RP.107)
  std::array<double, moments* moments> balance = {};  ///< A^-1 of (RP.107) [1/m^2]

  // In the present stage the force on a particle is w (mean + turn offset).
  Point<D> mean = {};                  ///< [N, in 2D N/m]
  std::array<double, D* D> turn = {};  ///< by rows [N/m, in 2D N/m^2]
};

/// A particle behind a patch.
template <int D>
struct ShearShare {
  std::int32_t slot, patch;
  double weight;         ///< w of (RP.107)
  double stress_weight;  ///< w' of (RP.112) [m]
  Point<D> offset;       ///< from the mean place of what is behind the patch [m]
};

/// The patches of one block, and the shares that particles have in patches.
template <int D>
struct BlockShear {
  struct Index {
    std::int32_t block, share;
  };
  std::vector<ShearPatch<D>> patches;
  std::vector<ShearShare<D>> shares;  ///< in these patches, of particles of any block
  std::vector<Index> own;             ///< shares of the particles of this block, in any patches
  /// [own] stress of the particle before the share was taken from it [Pa].
  std::vector<std::array<double, kernels::symmetric_components<D>>> before;
};

}  // namespace pliant::remeshed

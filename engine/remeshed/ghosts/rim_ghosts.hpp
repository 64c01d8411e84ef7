#pragma once

#include "engine/remeshed/ghosts/surface_fits.hpp"
#include "engine/remeshed/level_set/level_set.hpp"
#include "engine/remeshed/loads/surroundings.hpp"

namespace pliant::remeshed {

/// A ghost of the free surface whose fits are ready.
template <class T, int D>
struct FittedGhost {
  std::int32_t number;  ///< in its block
  Point<D> foot;        ///< foot point [m]
  const FitSite<D>& site;
  const FitParticles<D>& particles;
  const kernels::FitTerms<T, D>& terms;
};

/// Lists a ghost of the free surface with the rim ghosts of its block if it lies behind a no-slip
/// wall that holds the body: the wall then determines its velocity, (RP.116).
template <class T, int D>
void list_at_rim(const FittedGhost<T, D>& ghost, const Lattice<D>& lattice,
                 const LevelSet<T, D>& level_set, const Boundaries<D>& boundaries,
                 BlockGhosts<T, D>& ghosts);

/// Sets the velocities of the rim ghosts among the first `count` ghosts of a block, (RP.116). They
/// move with it: it is no outgoing wave.
template <class T, int D>
void fill_rim_ghosts(const Body<T, D>& body, BlockGhosts<T, D>& ghosts, std::size_t count,
                     const Surroundings<D>& around, FieldStore<T, D>& state);

}  // namespace pliant::remeshed

#pragma once

#include "engine/case/case.hpp"
#include "engine/remeshed/level_set/level_set.hpp"
#include "engine/remeshed/state/body.hpp"

namespace pliant::remeshed {

/// What ghosts are found from.
template <class T, int D>
struct GhostSearch {
  const Body<T, D>& body;  ///< before the remeshing
  Population<T, D>& population;
  const LevelSet<T, D>& level_set;
  const Boundaries<D>& boundaries;
  GhostTreatment treatment;
  int stencil_reach;
  const kernels::RemeshedTable<T, D>& kernels;
};

/// Finds the ghosts of a block and the terms of their fits, (RP.43), (RP.44), (RP.49), and
/// marks the particles that they read in `used`. Ghosts that some particle's stencil reaches, and
/// all of walls, come first.
template <class T, int D>
void fit_ghosts(const GhostSearch<T, D>& search, int block, std::int32_t* used);

/// Lists the packs of a block with particles that some fit uses.
template <class T, int D>
void list_surface_particles(Population<T, D>& population, int block, const std::int32_t* used);

/// Numbers the records of all blocks in order and keeps how far their particles are from the
/// surface, then tells every fit the records of the particles whose slots it has named so far.
template <class T, int D>
void number_records(Population<T, D>& population, const LevelSet<T, D>& level_set, double spacing,
                    std::int32_t* record_of_slot);
template <class T, int D>
void list_slots_of_records(Population<T, D>& population);
template <class T, int D>
void resolve_records(Population<T, D>& population, int block, const std::int32_t* record_of_slot);

}  // namespace pliant::remeshed

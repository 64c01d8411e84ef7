#pragma once

#include "engine/case/case.hpp"
#include "engine/remeshed/ghosts/reentrant_corners.hpp"
#include "engine/remeshed/level_set/level_set.hpp"
#include "engine/remeshed/state/body.hpp"

namespace pliant::remeshed {

/// The arguments of the search for ghosts.
template <class T, int D>
struct GhostSearch {
  const Body<T, D>& body;  ///< before the remeshing
  Population<T, D>& population;
  const LevelSet<T, D>& level_set;
  const Boundaries<D>& boundaries;
  const ReentrantCorners<D>& corners;
  GhostTreatment treatment;
  int stencil_reach;
  const kernels::RemeshedTable<T, D>& kernels;
};

/// Finds the ghosts of a block and the terms of their fits, (RP.43), (RP.44), (RP.49). Marks the
/// particles that they read in `used`. Ghosts that the stencil of some particle reaches, and all
/// ghosts of walls, come first.
template <class T, int D>
void fit_ghosts(const GhostSearch<T, D>& search, int block, std::int32_t* used);

/// Lists the packs of a block that have particles of some fit.
template <class T, int D>
void list_surface_particles(Population<T, D>& population, int block, const std::int32_t* used);

/// Numbers the records of all blocks in order and stores the distances of their particles from the
/// surface. Then replaces the slots of particles in the fits by records.
template <class T, int D>
void number_records(Population<T, D>& population, const LevelSet<T, D>& level_set, double spacing,
                    std::int32_t* record_of_slot);
template <class T, int D>
void list_slots_of_records(Population<T, D>& population);
template <class T, int D>
void resolve_records(Population<T, D>& population, int block, const std::int32_t* record_of_slot);

}  // namespace pliant::remeshed

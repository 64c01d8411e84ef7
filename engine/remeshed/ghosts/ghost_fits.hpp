#pragma once

#include "engine/case/case.hpp"
#include "engine/remeshed/body.hpp"
#include "engine/remeshed/level_set/level_set.hpp"

namespace pliant::remeshed {

inline constexpr double ghost_band = 4.2;  ///< [h]

/// Kinds of the slots of one block from the level set and the walls; vacant slots get harmless
/// values.
///
///     phi < 0, outside every wall        interior (when remeshing reached it: `valid`)
///     inside a wall, phi < 4.2 h         wall ghost, as deep as 4.2 h
///     0 <= phi < 4.2 h                   free ghost
///
/// Images are left vacant; plain SPH has vacant slots in the place of ghosts. Returns the number of
/// interior particles.
template <class T, int D>
std::int64_t classify(const Body<T, D>& body, Population<T, D>& population, FieldStore<T, D>& state,
                      int block, const Boundaries<D>& boundaries, const T* valid);

/// Whether the packs of a segment hold interior particles, from the kinds of their slots.
template <class T, int D>
void find_pack_states(Population<T, D>& population, const kernels::Segment<D>& segment);

/// Makes a block ready for steps: marks its interior particles, and puts at rest what the stages
/// leave alone of their copies of the state, packs without interior particles. Ghosts among them
/// get their velocity and stress in every stage.
template <class T, int D>
void prepare_slots(Body<T, D>& body, int block);

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

/// Finds the ghosts of a block and the terms of their fits, (RP.32), (RP.33), (RP.38), and
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

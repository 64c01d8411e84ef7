#pragma once

#include "engine/boundaries/walls.hpp"
#include "engine/remeshed/state/body.hpp"

/// What the slots of a body hold: particles, ghosts or nothing.
namespace pliant::remeshed {

inline constexpr double ghost_band = 4.2;  ///< [h]

/// What slots outside a body hold: ghosts, where its method has them.
enum class Outside { ghosts, vacant };

/// Kinds of the slots of one block from the level set and the walls; vacant slots get harmless
/// values.
///
///     phi < 0, outside every wall        interior (when remeshing reached it: `valid`)
///     inside a wall, phi < 4.2 h         wall ghost, as deep as 4.2 h
///     0 <= phi < 4.2 h                   free ghost
///
/// Images are left vacant, and free ghosts where `outside` says so. `valid` may lie where the drift
/// of `state` does, which becomes 0. Returns the number of interior particles.
template <class T, int D>
std::int64_t classify(const Body<T, D>& body, Population<T, D>& population, FieldStore<T, D>& state,
                      int block, const Boundaries<D>& boundaries, const T* valid, Outside outside);

/// Whether the packs of a segment hold interior particles, from the kinds of their slots.
template <class T, int D>
void find_pack_states(Population<T, D>& population, const kernels::Segment<D>& segment);

/// Makes a block ready for steps: marks its interior particles, and puts at rest what the stages
/// leave alone of their copies of the state, packs without interior particles. Ghosts among them
/// get their velocity and stress in every stage.
template <class T, int D>
void prepare_slots(Body<T, D>& body, int block);

}  // namespace pliant::remeshed

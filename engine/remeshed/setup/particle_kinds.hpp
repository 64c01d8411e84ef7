#pragma once

#include "engine/boundaries/walls.hpp"
#include "engine/remeshed/state/body.hpp"

/// The content of a body's slots: particles, ghosts or nothing.
namespace pliant::remeshed {

inline constexpr double ghost_band = 4.2;  ///< [h]

/// The content of slots outside a body: ghosts, if the method has them.
enum class Outside { ghosts, vacant };

/// Sets the kinds of the slots of one block from the level set and the walls; vacant slots get
/// harmless values.
///
///     phi < 0, outside every wall        interior (if remeshing reached it: `valid`)
///     inside a wall, phi < 4.2 h         wall ghost, down to a depth of 4.2 h
///     0 <= phi < 4.2 h                   free ghost
///
/// Images stay vacant, and free ghosts too if `outside` is `vacant`. `valid` may share memory with
/// the drift of `state`, which becomes 0. Returns the number of interior particles.
template <class T, int D>
std::int64_t classify(const Body<T, D>& body, Population<T, D>& population, FieldStore<T, D>& state,
                      int block, const Boundaries<D>& boundaries, const T* valid, Outside outside);

/// Finds which packs of a segment have interior particles, from the kinds of their slots.
template <class T, int D>
void find_pack_states(Population<T, D>& population, const kernels::Segment<D>& segment);

/// Prepares a block for steps: marks its interior particles, and sets packs without interior
/// particles to rest in all copies of the state, since stages skip them. Their ghosts get velocity
/// and stress in every stage.
template <class T, int D>
void prepare_slots(Body<T, D>& body, int block);

}  // namespace pliant::remeshed

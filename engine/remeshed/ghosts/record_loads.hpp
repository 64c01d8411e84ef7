#pragma once

#include "engine/boundaries/boundary_values.hpp"
#include "engine/remeshed/ghosts/initial_faces.hpp"
#include "engine/remeshed/ghosts/load_place.hpp"

/// The loads on the surface near ghosts, (RP.78).
namespace pliant::remeshed {

/// In place of the number of a load, where several act on the surface around a ghost.
inline constexpr std::int8_t several_loads = -2;

/// Finds the face nearest to each surface particle of a block, and the loads there. Particles must
/// be on nodes. `fields` are those of the nodes, `surface` the free surface at t = 0.
template <class T, int D>
void find_record_loads(const Lattice<D>& lattice, const FieldStore<T, D>& fields,
                       const Shape& surface, const Boundaries<D>& boundaries, int block,
                       Population<T, D>& population);

/// Sets the loads of the free-surface ghosts in a block: those of the faces of (RP.78).
template <class T, int D>
void find_ghost_loads(const Lattice<D>& lattice, const FieldStore<T, D>& fields,
                      const Shape& surface, const Boundaries<D>& boundaries, int block,
                      Population<T, D>& population);

/// The load on a ghost, taken from `place`, and the normal of the ghost; with `several_loads` the
/// traction of (RP.78).
template <class T, int D>
kernels::SurfaceLoad<T, D> load_on_ghost(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts,
                                         const kernels::GhostFits<T, D>& fits, std::size_t ghost,
                                         const LoadPlace<T, D>& place,
                                         const BoundaryValues<D>& values);

}  // namespace pliant::remeshed

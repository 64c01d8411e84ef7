#pragma once

#include "engine/boundaries/boundary_values.hpp"
#include "engine/remeshed/state/body.hpp"

/// Which loads act on the surface near ghosts, (RP.78).
namespace pliant::remeshed {

/// In the place of the number of a load.
inline constexpr std::int8_t no_load = -1;
inline constexpr std::int8_t several_loads = -2;  ///< on the surface around a ghost

/// A place of the surface as it was at t = 0.
template <int D>
struct InitialFace {
  Point<D> normal;  ///< unit, out of the body
  std::int8_t load;
};

/// The face of a surface nearest to `start`, and the load that acts on it there.
template <int D>
InitialFace<D> face_at(const Boundaries<D>& boundaries, const Shape& surface,
                       const Point<D>& start);

/// Finds the faces to which a block's surface particles were nearest, which lie on nodes, and the
/// loads on them. `fields` are those of the nodes, `surface` the free surface at t = 0.
template <class T, int D>
void find_record_loads(const Lattice<D>& lattice, const FieldStore<T, D>& fields,
                       const Shape& surface, const Boundaries<D>& boundaries, int block,
                       Population<T, D>& population);

/// Gives the ghosts of the free surface in a block of the new population their loads: in 2D those
/// of all faces of (RP.78), in 3D the one at the foot point. `surface` is the free surface at t =
/// 0.
template <class T, int D>
void find_ghost_loads(Body<T, D>& body, const Shape& surface, const Boundaries<D>& boundaries,
                      int block);

/// The traction of `several_loads` on a ghost, and the normal that belongs to it, (RP.78).
template <class T, int D>
kernels::SurfaceLoad<T, D> mixed_load(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts,
                                      std::size_t ghost, const BoundaryValues<D>& values);

}  // namespace pliant::remeshed

#pragma once

#include "engine/boundaries/boundary_values.hpp"
#include "engine/remeshed/state/body.hpp"

/// The loads on the surface near ghosts, (RP.78).
namespace pliant::remeshed {

/// Values in place of the number of a load.
inline constexpr std::int8_t no_load = -1;
inline constexpr std::int8_t several_loads = -2;  ///< on the surface around a ghost

/// A place of the surface at t = 0.
template <int D>
struct InitialFace {
  Point<D> normal;  ///< unit, out of the body
  std::int8_t load;
};

/// The face of a surface nearest to `start`, and the load there.
template <int D>
InitialFace<D> face_at(const Boundaries<D>& boundaries, const Shape& surface,
                       const Point<D>& start);

/// The present direction of the normal N of a face at t = 0, F^-T N with F^-1 = I - grad d from the
/// nodes beside that of a cell. Particles must be on nodes.
template <class T, int D>
Point<D> present_normal(const Lattice<D>& lattice, const Layout<D>& layout,
                        const FieldStore<T, D>& fields, const Cell<D>& cell,
                        const Point<D>& initial);

/// Finds the face nearest to each surface particle of a block, and the loads there. Particles must
/// be on nodes. `fields` are those of the nodes, `surface` the free surface at t = 0.
template <class T, int D>
void find_record_loads(const Lattice<D>& lattice, const FieldStore<T, D>& fields,
                       const Shape& surface, const Boundaries<D>& boundaries, int block,
                       Population<T, D>& population);

/// Sets the loads of the free-surface ghosts in a block: those of the faces of (RP.78).
template <class T, int D>
void find_ghost_loads(Population<T, D>& population, int block);

/// The traction of `several_loads` on a ghost, and its normal, (RP.78).
template <class T, int D>
kernels::SurfaceLoad<T, D> mixed_load(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts,
                                      const kernels::GhostFits<T, D>& fits, std::size_t ghost,
                                      const BoundaryValues<D>& values);

}  // namespace pliant::remeshed

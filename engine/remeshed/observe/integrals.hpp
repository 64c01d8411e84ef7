#pragma once

#include "engine/boundaries/walls.hpp"
#include "engine/method/body_integrals.hpp"
#include "engine/remeshed/state/lattice_view.hpp"
#include "scheduler/workers.hpp"

namespace pliant::remeshed {

/// Integrals over {phi < 0} in front of all walls, (RP.42), (RP.62), (RP.63), (RP.70).
template <class T, int D>
BodyIntegrals integrate(const LatticeView<T, D>& view, const Boundaries<D>& boundaries,
                        const Vector& about);

/// The same to the last bit, with blocks in parallel.
template <class T, int D>
BodyIntegrals integrate(const LatticeView<T, D>& view, const Boundaries<D>& boundaries,
                        const Vector& about, scheduler::Workers& workers);

/// Sums over the particles, for bodies that are never remeshed or have no surface.
template <class T, int D>
BodyIntegrals sum_particles(const Body<T, D>& body, const Vector& about);

}  // namespace pliant::remeshed

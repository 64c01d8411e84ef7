#pragma once

#include "engine/total_lagrangian/state.hpp"

namespace pliant::total_lagrangian {

/// Makes a body of a case: its lattice, particles, stress points and surface, at rest or with the
/// case's initial velocity. Throws InputError when the lattice is too coarse for it.
template <class T, int D>
void make_body(const Case& settings, const BodyCase& source, const Boundaries<D>& boundaries,
               Body<T, D>& body);

/// Finds the free surface of a body, and what pressures on it do to which particles.
template <class T, int D>
void make_surface(const Boundaries<D>& boundaries, Body<T, D>& body);

}  // namespace pliant::total_lagrangian

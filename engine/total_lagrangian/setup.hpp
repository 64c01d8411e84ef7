#pragma once

#include "engine/total_lagrangian/state.hpp"

namespace pliant::total_lagrangian {

/// Makes a body of a case: its lattice, particles, stress points and surface, at rest or with the
/// initial velocity of the case. Throws InputError when the lattice is too coarse for the body.
template <class T, int D>
void make_body(const Case& settings, const BodyCase& source, const Boundaries<D>& boundaries,
               Body<T, D>& body);

/// Finds the free surface of a body, and the nodal loads of the pressures on it.
template <class T, int D>
void make_surface(const Boundaries<D>& boundaries, Body<T, D>& body);

}  // namespace pliant::total_lagrangian

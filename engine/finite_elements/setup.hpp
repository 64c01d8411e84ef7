#pragma once

#include "engine/finite_elements/state.hpp"

namespace pliant::finite_elements {

/// Makes a body of a case from its mesh, at rest or with the case's initial velocity. Throws
/// InputError for a mesh that is no body.
template <class T, int D>
void make_body(const Case& settings, const BodyCase& source, const Boundaries<D>& boundaries,
               point_based::Body<T, D>& body, Elements<T, D>& elements);

}  // namespace pliant::finite_elements

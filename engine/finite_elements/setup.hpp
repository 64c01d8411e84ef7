#pragma once

#include "engine/finite_elements/state.hpp"

namespace pliant::finite_elements {

/// Makes a body of a case from its mesh, at rest or with the initial velocity of the case. Throws
/// InputError for a mesh that does not form a body.
template <class T, int D>
void make_body(const Case& settings, const BodyCase& source, const Boundaries<D>& boundaries,
               point_based::Body<T, D>& body, Elements<T, D>& elements);

}  // namespace pliant::finite_elements

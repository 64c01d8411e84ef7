#pragma once

#include "engine/geometry/shape.hpp"
#include "engine/remeshed/body.hpp"

namespace pliant::remeshed {

/// Displacement since t = 0 of the material point that started at `start` [m]: the linear fit
/// through the particles that started around it. NaN where they are too few for a fit.
template <class T, int D>
Vector material_displacement(const Body<T, D>& body, const Vector& start);

}  // namespace pliant::remeshed

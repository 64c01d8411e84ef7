#pragma once

#include "engine/boundaries/boundary_values.hpp"
#include "engine/remeshed/loads/body_forces.hpp"

namespace pliant::remeshed {

/// The walls and loads around a block at a stage.
template <int D>
struct Surroundings {
  const Boundaries<D>& boundaries;
  const BoundaryValues<D>& values;
  BodyForce<D> body_force;
};

}  // namespace pliant::remeshed

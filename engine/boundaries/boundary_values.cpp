#include "engine/boundaries/boundary_values.hpp"

namespace pliant {

template <int D>
void BoundaryValues<D>::evaluate(const Boundaries<D>& boundaries, double t) {
  wall_velocity.clear();
  pressure.clear();
  for (const Wall<D>& wall : boundaries.walls) wall_velocity.push_back(wall.velocity(t));
  boundaries_ = &boundaries;
  time_ = t;
  traction_.clear();
  for (const SurfacePressure<D>& load : boundaries.pressures) {
    pressure.push_back(load.is_uniform() ? load.pressure({}, t) : 0);
    traction_.push_back(load.is_uniform() ? load.traction({}, t) : Point<D>{});
  }
}

template struct BoundaryValues<2>;
template struct BoundaryValues<3>;

}  // namespace pliant

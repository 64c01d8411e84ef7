#include "engine/boundaries/boundary_values.hpp"

namespace pliant {

template <int D>
void BoundaryValues<D>::evaluate(const Boundaries<D>& boundaries, double t) {
  pressure.clear();
  boundaries_ = &boundaries;
  time_ = t;
  traction_.clear();
  for (const SurfacePressure<D>& load : boundaries.pressures) {
    pressure.push_back(load.is_uniform() ? load.pressure({}, t) : 0);
    traction_.push_back(load.is_uniform() ? load.traction({}, t) : Point<D>{});
  }
}

template <int D>
void BoundaryValues<D>::move_walls(std::span<const WallPose<D>> since) {
  wall_motion.clear();
  for (std::size_t w = 0; w < since.size(); ++w) {
    wall_motion.push_back(boundaries_->walls[w].motion(time_, since[w]));
  }
}

template struct BoundaryValues<2>;
template struct BoundaryValues<3>;

}  // namespace pliant

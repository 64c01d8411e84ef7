#pragma once

#include <span>
#include <vector>

#include "engine/boundaries/walls.hpp"

namespace pliant {

/// The values of the boundary conditions at one time.
template <int D>
struct BoundaryValues {
  std::vector<RigidMotion<D>> wall_motion;  ///< [wall], by `move_walls`
  std::vector<double> pressure;             ///< [load] [Pa]; 0 if it is not uniform, or a traction

  /// Evaluates the loads. `boundaries` must outlive the values.
  void evaluate(const Boundaries<D>& boundaries, double t);
  /// Evaluates the motions of the walls, at the same time, from their poses `since` [wall] on.
  void move_walls(std::span<const WallPose<D>> since);
  /// Pressure [Pa] and traction [Pa] of a load at x; one of them is 0.
  double pressure_at(int load, const Point<D>& x) const {
    return loads()[load].is_uniform() ? pressure[load] : loads()[load].pressure(x, time_);
  }
  Point<D> traction_at(int load, const Point<D>& x) const {
    return loads()[load].is_uniform() ? traction_[load] : loads()[load].traction(x, time_);
  }

 private:
  const std::vector<SurfacePressure<D>>& loads() const { return boundaries_->pressures; }

  const Boundaries<D>* boundaries_ = nullptr;
  double time_ = 0;
  std::vector<Point<D>> traction_;  ///< [load] [Pa]; 0 if it is not uniform, or a pressure
};

}  // namespace pliant

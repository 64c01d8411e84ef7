#pragma once

#include <vector>

#include "engine/boundaries/walls.hpp"

namespace pliant {

/// The values of the boundary conditions at one time.
template <int D>
struct BoundaryValues {
  std::vector<Point<D>> wall_velocity;  ///< [wall] [m/s]
  std::vector<double> pressure;         ///< [load] [Pa]; 0 if it is not uniform, or a traction

  /// `boundaries` must outlive the values.
  void evaluate(const Boundaries<D>& boundaries, double t);
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

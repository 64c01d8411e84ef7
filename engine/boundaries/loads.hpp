#pragma once

#include <array>
#include <cstddef>

namespace pliant {

/// The loads and wall velocities of a case, for callers that change them between steps: a value set
/// here then replaces that of the case. Boundaries are numbered as in the case.
class Loads {
 public:
  virtual ~Loads() = default;

  /// Pressure on a region of the surface [Pa]. Throws std::invalid_argument for a wall.
  virtual void set_pressure(std::size_t boundary, double pressure) = 0;
  /// Velocity of a wall [m/s]. Throws std::invalid_argument for a pressure.
  virtual void set_wall_velocity(std::size_t boundary, const std::array<double, 3>& velocity) = 0;
};

}  // namespace pliant

#pragma once

#include <array>
#include <cstddef>

namespace pliant {

/// What the boundaries of a case do to its bodies, for callers that change it between steps: from
/// then on the value given here holds in the place of that of the case. Boundaries have the numbers
/// of the case.
class Loads {
 public:
  virtual ~Loads() = default;

  /// Pressure on a region of the surface [Pa]. Throws std::invalid_argument for a wall.
  virtual void set_pressure(std::size_t boundary, double pressure) = 0;
  /// Velocity of a wall [m/s]. Throws std::invalid_argument for a pressure.
  virtual void set_wall_velocity(std::size_t boundary, const std::array<double, 3>& velocity) = 0;
};

}  // namespace pliant

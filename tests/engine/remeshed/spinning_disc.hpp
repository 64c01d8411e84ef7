#pragma once

#include "tests/engine/remeshed/small_case.hpp"

namespace pliant::test {

/// The disc of radius 1 about `centre` at the start of its rotation, with nodes placed irregularly
/// relative to its surface.
inline Case spinning_disc(double spacing, const std::string& centre = "[0.013, -0.021]") {
  return small_case(
      "rotating_cylinder",
      {"discretisation.spacing=" + std::to_string(spacing),
       "discretisation.kernel=quartic_spline_fit",  // its stencil reaches two layers of ghosts
       "body.cylinder.geometry={ shape = \"disc\", centre = " + centre + ", radius = 1 }",
       "body.cylinder.rotation={ centre = " + centre + ", angular_velocity = 3 }"});
}

inline constexpr double pi = 3.14159265358979323846;

}  // namespace pliant::test

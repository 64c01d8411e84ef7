#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/engine/case/written_case.hpp"
#include "tests/engine/remeshed/spinning_disc.hpp"

namespace pliant::test {
namespace {

constexpr double flier_radius = 0.4, flier_spin = 1.3, flight[] = {1.5, 0.7};

/// A disc of 1 kg/m^2 that spins and flies through the corners of a periodic cell of 2 m by 2 m.
Case flying_disc() {
  return tests::read_text(R"(dimension = 2
discretisation = { spacing = 0.05 }
time = { end = 2 }
[periodic]
axes = ["x", "y"]
lower = [0, 0]
upper = [2, 2]
[[body]]
name = "disc"
geometry = { shape = "disc", centre = [1, 1], radius = 0.4 }
material = { model = "linear", density = 1, youngs_modulus = 100, poissons_ratio = 0.3 }
velocity = [1.5, 0.7]
rotation = { centre = [1, 1], angular_velocity = 1.3 }
[[measurement]]
name = "volume"
kind = "volume"
[[measurement]]
name = "area"
kind = "surface_area"
[[measurement]]
name = "x"
kind = "centre_of_mass"
[[measurement]]
name = "y"
kind = "centre_of_mass"
axis = "y"
[[measurement]]
name = "spin"
kind = "angular_momentum"
point = [0.3, 0.2]
[[measurement]]
name = "displacement"
kind = "point_displacement"
point = [1.3, 1]
[[measurement]]
name = "velocity"
kind = "material_value"
field = "velocity_x"
point = [1.3, 1]
)");
}

// A disc with a radius of 8 spacings: wherever it is, volume and surface are right within 0.2 %, as
// those of a disc without a periodic cell.
TEST(periodic_bodies, keep_their_surface_and_their_places_through_the_ends_of_the_cell) {
  const Case settings = flying_disc();
  Solver solver(settings, {1, kernels::Isa::sse2});
  const double mass = pi * flier_radius * flier_radius;
  const double angular_momentum =
      mass * (0.7 * flight[1] - 0.8 * flight[0] + flier_spin * flier_radius * flier_radius / 2);
  for (int i = 1; i <= 40; ++i) {
    const double t = 0.05 * i;
    advance_until(solver, t);
    const std::vector<double> value = solver.measure();
    EXPECT_NEAR(value[0] / mass, 1, 2e-3) << t;
    EXPECT_NEAR(value[1] / (2 * pi * flier_radius), 1, 2e-3) << t;
    EXPECT_NEAR(value[2], 1 + flight[0] * t, 1e-3) << t;
    EXPECT_NEAR(value[3], 1 + flight[1] * t, 1e-3) << t;
    EXPECT_NEAR(value[4] / angular_momentum, 1, 2e-3) << t;
    EXPECT_NEAR(value[5], flight[0] * t + 0.3 * (std::cos(flier_spin * t) - 1), 2e-3) << t;
    EXPECT_NEAR(value[6], flight[0] - flier_spin * 0.3 * std::sin(flier_spin * t), 0.03) << t;
  }
}

}  // namespace
}  // namespace pliant::test

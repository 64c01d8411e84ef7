#include <gtest/gtest.h>

#include "engine/remeshed/solver.hpp"
#include "tests/engine/remeshed/small_case.hpp"

// The headline figures of docs/validation, with the default settings. Each tolerance is the
// deviation stated there plus a margin for changes that need no review.
namespace pliant::test {
namespace {

template <int D = 2>
double at_end(const Case& settings, const std::string& measurement) {
  std::size_t m = 0;
  while (settings.measurements.at(m).name != measurement) ++m;
  remeshed::Solver<double, D> solver(settings, {2, kernels::widest_supported()});
  std::vector<double> start = solver.measure();
  advance_until(solver, settings.time.end);
  const double value = solver.measure()[m];
  return settings.measurements[m].relative ? value / start[m] : value;
}

// Flank at t = 0.02 s, from converged finite elements [m].
TEST(headline, the_flank_of_512_particles_bulges_as_finite_elements_do) {
  const Settings coarse = {"discretisation.spacing=1/16"};
  const Settings logarithmic = {"material.block.equation_of_state=logarithmic"};
  const std::string flank = "flank_max_displacement";
  EXPECT_NEAR(at_end(small_case("compression_linear", coarse), flank) / 0.2440, 1, 0.01);
  EXPECT_NEAR(at_end(small_case("compression_linear", coarse + logarithmic), flank) / 0.2326, 1,
              0.01);
  EXPECT_NEAR(at_end(small_case("compression_hyperelastic", coarse), flank) / 0.2508, 1, 0.01);
}

TEST(headline, the_flank_of_2048_particles_bulges_as_finite_elements_do) {
  const Settings logarithmic = {"material.block.equation_of_state=logarithmic"};
  const std::string flank = "flank_max_displacement";
  EXPECT_NEAR(at_end(small_case("compression_linear", {}), flank) / 0.2440, 1, 0.004);
  EXPECT_NEAR(at_end(small_case("compression_linear", logarithmic), flank) / 0.2326, 1, 0.004);
  EXPECT_NEAR(at_end(small_case("compression_hyperelastic", {}), flank) / 0.2508, 1, 0.004);
}

TEST(headline, five_turns_keep_the_angular_momentum_and_the_energy) {
  const Case five_turns = small_case("rotating_cylinder", {"time.end=5"});
  EXPECT_NEAR(at_end(five_turns, "angular_momentum_ratio"), 1, 2e-3);
  EXPECT_NEAR(at_end(five_turns, "energy_ratio"), 1, 0.01);
}

// A square of 1 m: remeshing rounds edges and lets them swell.
TEST(headline, four_turns_keep_the_mass_and_the_angular_momentum_of_a_square) {
  const Settings square = {
      R"(body.cylinder.geometry={ shape = "box", lower = [-0.5, -0.5], upper = [0.5, 0.5] })",
      "body.cylinder.material.youngs_modulus=10",
      "body.cylinder.rotation={ centre = [0, 0], angular_velocity = 0.5 }", "time.end=16*pi",
      R"(measurement=[{ name = "mass", kind = "mass", relative = true }, )"
      R"({ name = "angular_momentum", kind = "angular_momentum", point = [0, 0], )"
      R"(relative = true }])"};
  for (const char* spacing : {"discretisation.spacing=1/10", "discretisation.spacing=1/20"}) {
    const Case turning = small_case("rotating_cylinder", square + Settings{spacing});
    EXPECT_NEAR(at_end(turning, "mass"), 1, 0.01) << spacing;
    EXPECT_NEAR(at_end(turning, "angular_momentum"), 1, 0.01) << spacing;
  }
}

// Finite elements give 0.987.
TEST(headline, a_ball_of_8000_particles_leaves_the_wall_with_its_momentum) {
  const Case sticking = small_case("bouncing_ball", {"boundary.wall.friction=no_slip"});
  EXPECT_NEAR(at_end<3>(small_case("bouncing_ball", {}), "momentum_ratio"), -0.987, 0.01);
  EXPECT_NEAR(at_end<3>(sticking, "momentum_ratio"), -0.987, 0.01);
}

}  // namespace
}  // namespace pliant::test

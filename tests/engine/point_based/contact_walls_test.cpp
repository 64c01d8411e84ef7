#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/simulation/passing_bodies.hpp"
#include "tests/engine/point_based/blocks.hpp"
#include "tests/engine/undeformed/loads.hpp"

// Contact walls of the point-based method: friction, tools, planes of symmetry.
namespace pliant::test {
namespace {

// Coulomb's law on a slope: friction is mu times the normal impulse. The stiff block shears a
// little before it slides.
TEST(point_contact, a_block_slides_down_a_slope_by_coulombs_law) {
  const double mu = 0.3, g = 5, angle = 0.5;
  const std::string text =
      "gravity = [" + std::to_string(g * std::sin(angle)) + ", " +
      std::to_string(-g * std::cos(angle)) + "]\n" + free_points(2) +
      half_space("floor", "kind = \"contact_wall\"\nfriction = 0.3", "[0, 0]", "[0, 1]") +
      measurement("normal", "kind = \"wall_force\"\nboundary = \"floor\"\naxis = \"y\"");
  const Case settings =
      tests::read_text(text, {"material.rubber.youngs_modulus=1e4", "discretisation.spacing=0.25"});
  PointSolver<2> solver(settings, {1, kernels::widest_supported()});
  advance_until(solver, 1);
  const double pushed = values(solver)["normal"];
  EXPECT_NEAR(pushed, g * std::cos(angle), 0.3);
  const double sliding = g * std::sin(angle) - mu * pushed;
  EXPECT_NEAR(solver.integrals().momentum[0], sliding, 0.02 * sliding);
  // mu N times the path of a block of 1 kg with this acceleration
  EXPECT_NEAR(solver.energy_budget()->friction, mu * pushed * sliding / 2,
              0.05 * mu * pushed * sliding / 2);
}

TEST(point_contact, a_tool_dents_a_block_and_its_work_is_in_the_block) {
  const std::string text = free_points(2) +
                           half_space("floor", "kind = \"fixed\"", "[0, 0]", "[0, 1]") +
                           R"toml([[boundary]]
name = "tool"
kind = "contact_wall"
friction = "frictionless"
geometry = { shape = "disc", centre = [0.5, 1.5], radius = 0.5 }
displacement = [0, "-0.1*min(t, 1)"]
)toml";
  const Case settings = tests::read_text(text, {"discretisation.spacing=0.0625"});
  PointSolver<2> solver(settings, {1, kernels::widest_supported()});
  advance_until(solver, 1.2);
  const auto& body = solver.state().bodies[0];
  for (std::size_t c = 0; c < body.surface.start.size(); ++c) {
    const Point<2> x = body.position(body.surface.node[c]);
    // The mean of a facet is outside; h^2/(4 R) is 2e-3 m.
    EXPECT_GT(std::hypot(x[0] - 0.5, x[1] - 1.4), 0.5 - 2e-3);
  }
  const double work = solver.energy_budget()->wall_work;
  EXPECT_GT(work, 0);
  EXPECT_LT(std::abs(balance(solver)), 0.03 * work);
}

// A capsule, two balls and a cylinder between them, comes down on a block obliquely and slides.
TEST(point_contact, a_capsule_that_moves_dents_a_block_and_nothing_enters_it) {
  const std::string text = free_points(3) +
                           half_space("floor", "kind = \"fixed\"", "[0, 0, 0]", "[0, 0, 1]") +
                           R"toml([[boundary]]
name = "capsule"
kind = "contact_wall"
friction = "frictionless"
displacement = ["0.2*max(t - 0.5, 0)", 0, "-0.25*min(t, 0.5)"]

[boundary.geometry]
shape = "union"
of = [{ shape = "ball", centre = [0.3, 0.2, 1.2], radius = 0.15 },
      { shape = "ball", centre = [0.5, 0.7, 1.2], radius = 0.15 },
      { shape = "intersection", of = [
          { shape = "cylinder", centre = [0.3, 0.2, 1.2], radius = 0.15, axis = [0.2, 0.5, 0] },
          { shape = "half_space", point = [0.3, 0.2, 0], normal = [-0.2, -0.5, 0] },
          { shape = "half_space", point = [0.5, 0.7, 0], normal = [0.2, 0.5, 0] }] }]
)toml";
  const Case settings = tests::read_text(text, {"discretisation.spacing=0.0625"});
  PointSolver<3> solver(settings, {1, kernels::widest_supported()});
  advance_until(solver, 1);
  const auto& body = solver.state().bodies[0];
  double nearest = 1;
  for (std::size_t c = 0; c < body.surface.start.size(); ++c) {
    Point<3> x = body.position(body.surface.node[c]);
    const Point<3> end = {0.3 + 0.1, 0.2, 1.2 - 0.125}, along = {0.2, 0.5, 0};
    x = difference<3>(x, end);
    const double t = std::clamp(dot<3>(x, along) / dot<3>(along, along), 0., 1.);
    for (int a = 0; a < 3; ++a) x[a] -= t * along[a];
    nearest = std::min(nearest, std::sqrt(dot<3>(x, x)));
  }
  EXPECT_NEAR(nearest, 0.15, 2e-3);
  const double work = solver.energy_budget()->wall_work;
  EXPECT_GT(work, 0);
  EXPECT_LT(std::abs(balance(solver)), 0.01 * work);
}

/// A block of 1 m, and a ball on top that comes down at 0.2 m/s.
std::string block_under_ball(double radius) {
  return free_points(3) + "[point_based]\ndamping = 5\n" +
         half_space("floor", "kind = \"fixed\"", "[0, 0, 0]", "[0, 0, 1]") +
         fmt::format(R"toml([[boundary]]
name = "tool"
kind = "contact_wall"
displacement = [0, 0, "-0.2*t"]
geometry = {{ shape = "ball", centre = [0.5, 0.5, {}], radius = {} }}
)toml",
                     1 + radius, radius) +
         measurement("force", "kind = \"wall_force\"\nboundary = \"tool\"\naxis = \"z\"");
}

// Surface nodes slide off a ball that is pressed in deeper than its radius. It used to pass through
// the surface, and then the nodes above it pulled it down.
TEST(point_contact, a_small_tool_that_is_pressed_in_deep_is_resisted_more_and_more) {
  const Case settings =
      tests::read_text(block_under_ball(0.2), {"discretisation.spacing=0.05", "time.end=2"});
  PointSolver<3> solver(settings, {2, kernels::widest_supported()});
  double impulse = 0, before = 0;
  for (int sample = 1; sample <= 8; ++sample) {  // to a depth of 1.6 radii
    advance_until(solver, 0.2 * sample);
    const double now = values(solver)["force"], force = (impulse - now) / 0.2;
    EXPECT_GT(force, before) << "at a depth of " << 0.04 * sample;
    before = force;
    impulse = now;
  }
  EXPECT_EQ(passing_tool_warning(solver), "");
}

TEST(point_contact, a_needle_passes_between_the_particles_and_is_told_of) {
  const Case settings =
      tests::read_text(block_under_ball(0.02), {"discretisation.spacing=0.05", "time.end=2"});
  PointSolver<3> solver(settings, {2, kernels::widest_supported()});
  advance_until(solver, 1);
  EXPECT_NE(passing_tool_warning(solver).find("`tool` has got between the particles"),
            std::string::npos);
}

// A plane of symmetry halves the force on a tool and changes nothing else: nodes that slide along
// it are pushed too.
TEST(point_contact, a_plane_of_symmetry_halves_the_force) {
  double force[2];
  for (const bool half : {false, true}) {
    const std::string text =
        free_points(2) + half_space("floor", "kind = \"fixed\"", "[0, 0]", "[0, 1]") +
        (half ? half_space("symmetry", "kind = \"slip_wall\"", "[0.5, 0]", "[1, 0]") : "") +
        R"toml([[boundary]]
name = "tool"
kind = "contact_wall"
friction = "frictionless"
geometry = { shape = "disc", centre = [0.5, 2.0], radius = 1 }
displacement = [0, "-0.1*min(t/0.5, 1)"]
)toml" + measurement("force", "kind = \"wall_force\"\nboundary = \"tool\"\naxis = \"y\"");
    // The two bodies have different stable steps, and pushes depend on the step.
    std::vector<std::string> settings = {"point_based.damping=20", "time.step=4e-3"};
    if (half) {
      settings.push_back(
          "body.block.geometry={ shape = \"box\", lower = [0.5, 0], upper = [1, 1] }");
    }
    PointSolver<2> solver(tests::read_text(text, settings), {1, kernels::widest_supported()});
    advance_until(solver, 0.8);
    const double impulse = values(solver)["force"];
    advance_until(solver, 1);
    force[half ? 1 : 0] = values(solver)["force"] - impulse;
    EXPECT_NEAR(balance(solver), 0, 0.02 * solver.energy_budget()->wall_work);
  }
  EXPECT_NEAR(force[0] / 2, force[1], 0.01 * std::abs(force[1]));
}

}  // namespace
}  // namespace pliant::test

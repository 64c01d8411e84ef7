#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/engine/point_based/blocks.hpp"
#include "tests/engine/undeformed/loads.hpp"

// Gravity, tractions, reactions, contact walls, friction and the energy balance of the point-based
// method, against solutions in closed form.
namespace pliant::test {
namespace {

constexpr double youngs_modulus = 100;  // of free_points

TEST(point_loads, free_fall_is_exact) {
  for (const std::string gravity : {"[0.5, -9.81]", "[\"0.5 + 0*x\", -9.81]"}) {
    const Case settings = tests::read_text("gravity = " + gravity + "\n" + free_points(2));
    PointSolver<2> solver(settings, {1, kernels::widest_supported()});
    for (int i = 0; i < 50; ++i) solver.step(HUGE_VAL);
    const double t = solver.clock().time;
    const auto& body = solver.state().bodies[0];
    body.for_each_node([&](std::int64_t slot) {
      EXPECT_NEAR(body.displacement[0][slot], 0.5 * t * t / 2, 1e-11);
      EXPECT_NEAR(body.displacement[1][slot], -9.81 * t * t / 2, 1e-11);
    });
    EXPECT_NEAR(balance(solver), 0, 1e-11 * solver.integrals().kinetic_energy);
  }
}

// Output times lie anywhere in a step: momentum is that of their instant, and bodies are nearly on
// their parabola, (PB.45).
TEST(point_loads, free_fall_is_exact_within_steps) {
  const Case settings = tests::read_text("gravity = [0, -10]\n" + free_points(2));
  PointSolver<2> solver(settings, {1, kernels::widest_supported()});
  const auto start = solver.integrals();
  const double step = solver.time_step();
  for (const double share : {0.1, 0.5, 0.9, 1.0, 3.3}) {
    const double time = solver.clock().time + share * step;
    solver.advance(time);
    const auto now = solver.integrals();
    EXPECT_NEAR(now.momentum[1], -10 * time * now.mass, 1e-12 * now.mass) << share;
    const double fallen = (now.first_moment[1] - start.first_moment[1]) / now.mass;
    EXPECT_NEAR(fallen, -5 * time * time, 10 * step * step / 8 + 1e-12) << share;
  }
}

// Looking at an output time within a step leaves the rest of the run as it is.
TEST(point_loads, velocities_within_a_step_do_not_alter_the_run) {
  const Case settings = tests::read_text(free_points(2) + "velocity = [\"0.2*(x - 0.5)\", 0]\n");
  PointSolver<2> looked_at(settings, {1, kernels::widest_supported()});
  PointSolver<2> alone(settings, {1, kernels::widest_supported()});
  for (int i = 0; i < 5; ++i) {
    const double step = looked_at.time_step();
    looked_at.step(0.3 * step);
    looked_at.step(0.3 * step);
    looked_at.step(HUGE_VAL);
    alone.step(HUGE_VAL);
  }
  ASSERT_EQ(looked_at.clock().step, alone.clock().step);
  const auto& seen = looked_at.state().bodies[0];
  const auto& unseen = alone.state().bodies[0];
  seen.for_each_node([&](std::int64_t slot) {
    for (int a = 0; a < 2; ++a) {
      ASSERT_EQ(seen.velocity[a][slot], unseen.velocity[a][slot]);
      ASSERT_EQ(seen.displacement[a][slot], unseen.displacement[a][slot]);
    }
  });
}

// A block that swings freely: its energy varies within steps hardly more than from step to step.
TEST(point_energy_budget, kinetic_and_strain_energy_within_a_step_belong_together) {
  const Case settings = tests::read_text(free_points(2) + "velocity = [\"0.2*(x - 0.5)\", 0]\n");
  const auto spread = [&settings](double steps) {
    PointSolver<2> solver(settings, {1, kernels::widest_supported()});
    const double step = solver.time_step();
    double least = HUGE_VAL, most = 0;
    for (int sample = 1; sample * steps < 60; ++sample) {
      solver.advance(sample * steps * step);
      const auto now = solver.integrals();
      const double energy = now.kinetic_energy + now.strain_energy;
      least = std::min(least, energy);
      most = std::max(most, energy);
    }
    return most - least;
  };
  EXPECT_LT(spread(0.3), 1.1 * spread(1));
}

// F = sigma/E in a bar that slides along its floor; 1 % is what the stretch of 2 % makes of it.
TEST(point_loads, a_traction_stretches_a_bar_by_its_modulus) {
  const std::string text =
      free_points(3) + half_space("floor", "kind = \"slip_wall\"", "[0, 0, 0]", "[0, 0, 1]") +
      R"toml([[boundary]]
name = "pull"
kind = "traction"
geometry = { shape = "box", lower = [-9, -9, 0.999], upper = [9, 9, 9] }
traction = [0, 0, "2*(1 + 0*x)"]
area = "undeformed"
)toml" +
      measurement("top", "kind = \"point_displacement\"\npoint = [0.5, 0.5, 1]\naxis = \"z\"") +
      measurement("held", "kind = \"wall_force\"\nboundary = \"floor\"\naxis = \"z\"");
  const Case settings =
      tests::read_text(text, {"discretisation.spacing=0.25", "point_based.damping=8"});
  PointSolver<3> solver(settings, {1, kernels::widest_supported()});
  advance_until(solver, 3);
  const double impulse = values(solver)["held"], from = solver.clock().time;
  advance_until(solver, 3.5);
  EXPECT_NEAR(values(solver)["top"], 2 / youngs_modulus, 0.015 * 2 / youngs_modulus);
  const double force = (values(solver)["held"] - impulse) / (solver.clock().time - from);
  EXPECT_NEAR(force, -2, 1e-3);
}

// A dead load does not follow the surface, and one per present area grows with it.
TEST(point_loads, a_traction_acts_on_the_undeformed_or_on_the_present_area) {
  for (const bool present : {false, true}) {
    const std::string text = free_points(2) + R"toml([[boundary]]
name = "pull"
kind = "traction"
geometry = { shape = "box", lower = [-9, 0.999], upper = [9, 9] }
traction = [0, 3]
area = ")toml" + std::string(present ? "present" : "undeformed") +
                             "\"\n";
    const Case settings = tests::read_text(text);
    PointSolver<2> solver(settings, {1, kernels::widest_supported()});
    auto& body = solver.state().bodies[0];
    body.for_each_node(
        [&](std::int64_t slot) { body.displacement[0][slot] = 0.5 * body.start[slot][0]; });
    solver.step(HUGE_VAL);
    const double momentum = 3 * (present ? 1.5 : 1) * solver.clock().time;
    EXPECT_NEAR(solver.integrals().momentum[1], momentum, 1e-9 * momentum);
  }
}

TEST(point_loads, a_floor_carries_the_weight_of_the_body_on_it) {
  for (const std::string kind :
       {"kind = \"fixed\"", "kind = \"contact_wall\"\nfriction = \"frictionless\""}) {
    const std::string text =
        "gravity = [0, -5]\n" + free_points(2) + half_space("floor", kind, "[0, 0]", "[0, 1]") +
        measurement("force", "kind = \"wall_force\"\nboundary = \"floor\"\naxis = \"y\"");
    const Case settings = tests::read_text(text, {"point_based.damping=10"});
    PointSolver<2> solver(settings, {1, kernels::widest_supported()});
    advance_until(solver, 2);
    const double impulse = values(solver)["force"], from = solver.clock().time;
    advance_until(solver, 2.5);
    EXPECT_NEAR((values(solver)["force"] - impulse) / (solver.clock().time - from), 5, 0.01);
  }
}

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
    EXPECT_GT(std::hypot(x[0] - 0.5, x[1] - 1.4), 0.5 - 1e-3);
  }
  const double work = solver.energy_budget()->wall_work;
  EXPECT_GT(work, 0);
  EXPECT_LT(std::abs(balance(solver)), 0.03 * work);
}

// The loads start at once: steps are short for the waves that they make, whose energy the leapfrog
// sees to second order.
// A capsule is two balls and the cylinder between them. It comes down on a block, askew, and
// slides.
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

TEST(point_energy_budget, work_of_walls_loads_and_gravity_is_in_the_bar_or_was_damped) {
  const std::string text =
      "gravity = [\"sin(2*t)\", -3]\n" + free_points(2) +
      half_space("floor",
                 "kind = \"moving_wall\"\nvelocity = [\"t < 0.4 ? 1 - cos(15.7079633*t) : 0\", 0]",
                 "[0, 0]", "[0, 1]") +
      R"toml([[boundary]]
name = "pull"
kind = "traction"
geometry = { shape = "box", lower = [-9, 0.999], upper = [9, 9] }
traction = ["5*sin(3*t)", 4]
[[boundary]]
name = "push"
kind = "pressure"
geometry = { shape = "box", lower = [0.999, 0.3], upper = [9, 9] }
pressure = 3
)toml";
  for (const char* damping : {"0", "3"}) {
    const Case settings =
        tests::read_text(text, {std::string("point_based.damping=") + damping, "time.step=1e-3"});
    PointSolver<2> solver(settings, {1, kernels::widest_supported()});
    advance_until(solver, 0.8);
    const EnergyBudget budget = *solver.energy_budget();
    EXPECT_GT(std::abs(budget.load_work), 0.05);
    EXPECT_GT(budget.wall_work, 0.1);
    EXPECT_NEAR(balance(solver), 0, 0.01 * budget.wall_work);
    if (damping[0] != '0') {
      EXPECT_GT(budget.damping, 0.01 * budget.wall_work);
    }
  }
}

// What changed bonds and relaxing gradients do to the strain energy is in the budget, so that the
// balance closes through a cut.
// A plane of symmetry halves the force on a tool and nothing else: nodes that slide along it are
// pushed too.
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
    // The two bodies differ in their stable steps, and pushes come step by step.
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

TEST(point_energy_budget, closes_through_a_cut) {
  const std::string text =
      free_points(2) + half_space("left", "kind = \"fixed\"", "[0, 0]", "[1, 0]") +
      half_space("right", "kind = \"moving_wall\"\nvelocity = [\"t < 0.2 ? 0.5 : 0\", 0]", "[1, 0]",
                 "[-1, 0]") +
      R"toml([[cut]]
name = "blade"
from = [0.53, 1.1]
to = [0.53, 1.2]
path = [0, "-2*(t - 0.4)"]
start = 0.4
end = 0.8
)toml";
  const Case settings = tests::read_text(text, {"discretisation.spacing=0.0625"});
  PointSolver<2> solver(settings, {1, kernels::widest_supported()});
  advance_until(solver, 1);
  const EnergyBudget budget = *solver.energy_budget();
  EXPECT_NE(budget.cut_work, 0);
  EXPECT_NEAR(balance(solver), 0, 0.02 * budget.wall_work);
}

}  // namespace
}  // namespace pliant::test

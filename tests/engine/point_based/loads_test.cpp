#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/engine/point_based/blocks.hpp"
#include "tests/engine/undeformed/loads.hpp"

// Gravity, tractions and reactions of the point-based method, compared with solutions in closed
// form.
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

// Output times are anywhere within a step: momentum is exact at that time, and bodies are nearly on
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

// Observing an output time within a step does not change the rest of the run.
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

// The facets of the surface cut off the edge between the end and the side of a round bar.
TEST(point_loads, on_the_end_of_a_round_bar_act_on_all_of_it) {
  for (const std::string spacing : {"0.125", "0.1", "0.0625"}) {
    const Case settings = tests::read_text(
        tests::with(free_points(3), R"({ shape = "box", lower = [0, 0, 0], upper = [1, 1, 1] })",
                    R"({ shape = "intersection", of = [
  { shape = "cylinder", centre = [0, 0.5, 0.5], axis = [1, 0, 0], radius = 0.5 },
  { shape = "box", lower = [0, 0, 0], upper = [1.03, 1, 1] }] })") +
            R"toml([[boundary]]
name = "pull"
kind = "traction"
traction = [1, 0, 0]
geometry = { shape = "half_space", point = [1.029, 0, 0], normal = [-1, 0, 0] }
)toml",
        {"discretisation.spacing=" + spacing});
    const PointSolver<3> solver(settings, {1, kernels::widest_supported()});
    double area = 0;
    for (const auto& of_block : solver.state().bodies[0].pressed) {
      for (const auto& node : of_block) area += node.size;
    }
    const double end = std::numbers::pi / 4;
    EXPECT_NEAR(area, end, 0.03 * end) << spacing;
  }
}

// Points of bevelled facets are projected onto the face, with rounding errors of 1e-10.
TEST(point_loads, of_a_region_that_begins_in_the_plane_of_a_face_act_on_all_of_it) {
  for (const double side : {0.02, 0.03, 0.7, 1., 50.}) {
    for (const double from : {0., -0.5, 0.37}) {
      for (const std::string load :
           {"traction\"\ntraction = [1, 0, 0]", "pressure\"\npressure = 1"}) {
        const double lower = from * side, upper = lower + side;
        const Case settings = tests::read_text(
            tests::with(
                free_points(3), "lower = [0, 0, 0], upper = [1, 1, 1]",
                fmt::format("lower = [0, {0}, {0}], upper = [{1}, {2}, {2}]", lower, side, upper)) +
                fmt::format("[[boundary]]\nname = \"pull\"\nkind = \"{}\ngeometry = {{ shape = "
                            "\"box\", lower = [{}, -99, -99], upper = [99, 99, 99] }}\n",
                            load, side),
            {fmt::format("discretisation.spacing={}/7", side)});
        const PointSolver<3> solver(settings, {1, kernels::widest_supported()});
        double area = 0;
        for (const auto& of_block : solver.state().bodies[0].pressed) {
          for (const auto& node : of_block) area += node.size;
        }
        EXPECT_NEAR(area, side * side, 1e-9 * side * side) << side << " " << from << " " << load;
      }
    }
  }
}

// F = sigma/E in a bar that slides along its floor; a stretch of 2 % changes it by 1 %.
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

// With 12 neighbours in 2D, stresses on faces were 5 % too large (decision 63).
TEST(point_loads, a_traction_makes_the_same_stress_on_walls_and_faces_as_inside) {
  for (const int dimension : {2, 3}) {
    const bool is_flat = dimension == 2;
    std::string text =
        free_points(dimension) + "[point_based]\ndamping = 8\n" +
        half_space("wall", "kind = \"slip_wall\"", is_flat ? "[0, 0]" : "[0, 0, 0]",
                   is_flat ? "[1, 0]" : "[1, 0, 0]") +
        "[[boundary]]\nname = \"pull\"\nkind = \"traction\"\ntraction = [" +
        (is_flat ? "0.01, 0" : "0.01, 0, 0") + "]\ngeometry = { shape = \"box\", lower = " +
        (is_flat ? "[0.999999, -1], upper = [2, 2]" : "[0.999999, -1, -1], upper = [2, 2, 2]") +
        " }\n";
    const std::vector<std::string> places = {"0, 0.5", "0.5, 0", "1, 0.5", "0.125, 0.5",
                                             "0.5, 0.5"};
    for (const std::string& place : places) {
      text += measurement(fmt::format("at_{}", &place - places.data()),
                          "kind = \"material_value\"\nfield = \"stress_xx\"\npoint = [" + place +
                              (is_flat ? "]" : ", 0.5]"));
    }
    const auto run = methods().make(tests::read_text(text), {1});
    run->advance(3);
    for (const auto& [name, stress] : values(*run)) {
      EXPECT_NEAR(stress, 0.01, 0.005 * 0.01) << name << ", " << dimension << "D";
    }
  }
}

// A dead load does not follow the surface; a load per present area grows with the area.
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

}  // namespace
}  // namespace pliant::test

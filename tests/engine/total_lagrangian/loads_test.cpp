#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/engine/total_lagrangian/blocks.hpp"
#include "tests/engine/undeformed/loads.hpp"

// Gravity, tractions, reactions, contact and the energy balance, against solutions in closed form.
namespace pliant::test {
namespace {

constexpr double shear_modulus = 20, bulk_modulus = 2 / 0.05;  // of free_block

/// Takes full steps, so that walls have pushed for known times.
void take_steps(LagrangianSolver<2>& solver, int count) {
  for (int i = 0; i < count; ++i) solver.step(HUGE_VAL);
}

TEST(loads, free_fall_is_exact) {
  const Case settings = tests::read_text("gravity = [0.5, -9.81]\n" + free_block(2));
  LagrangianSolver<2> solver(settings, {1, kernels::widest_supported()});
  take_steps(solver, 50);
  const double t = solver.clock().time;
  for_each_particle<2>(solver.state().bodies[0], [&](std::int64_t p, const Point<2>&) {
    const auto& body = solver.state().bodies[0];
    EXPECT_NEAR(body.displacement[0][p], 0.5 * t * t / 2, 1e-11);
    EXPECT_NEAR(body.displacement[1][p], -9.81 * t * t / 2, 1e-11);
  });
  // Half a step before the end, at the time of the velocities, the work is exact; its rate of then
  // is used for the rest.
  EXPECT_NEAR(balance(solver), 0, 2 * std::pow(0.5 / 50, 2) * solver.integrals().kinetic_energy);
}

/// The area on which the loads of a body act.
template <int D>
double loaded_area(const LagrangianSolver<D>& solver) {
  const auto& body = solver.state().bodies[0];
  double sum = 0;
  for (const auto& patch : body.patches) {
    const Point<D> area = total_lagrangian::area_vector(body, body.facets[patch.facet]);
    double square = 0;
    for (const double component : area) square += component * component;
    sum += patch.share * std::sqrt(square);
  }
  return sum;
}

// The end face is not on the lattice, or its edges are cut off. The region is thin. Faces along the
// bar that lie on the lattice continue up to edges that do not.
TEST(loads, on_a_face_that_the_spacing_does_not_meet_act_on_all_of_it) {
  const auto pulled = [](int dimension, const std::string& upper) {
    return tests::with(free_block(dimension), dimension == 2 ? "[1, 1]" : "[1, 1, 1]", upper) +
           "[[boundary]]\nname = \"pull\"\nkind = \"traction\"\n" +
           (dimension == 2 ? "traction = [1, 0]\n" : "traction = [1, 0, 0]\n") +
           "geometry = { shape = \"half_space\", normal = " +
           (dimension == 2 ? "[-1, 0]" : "[-1, 0, 0]") + ", point = ";
  };
  for (const char* side : {"1.02", "1.06", "1.1"}) {
    const double end = std::stod(side) - 1e-3;
    const LagrangianSolver<2> plane(tests::read_text(pulled(2, fmt::format("[{}, 0.5]", side)) +
                                                     fmt::format("[{}, 0] }}\n", end)),
                                    {1, kernels::widest_supported()});
    EXPECT_NEAR(loaded_area(plane), 0.5 + 2e-3, 0.02 * 0.5) << side;
    const LagrangianSolver<3> bar(tests::read_text(pulled(3, fmt::format("[{}, 0.6, 0.5]", side)) +
                                                   fmt::format("[{}, 0, 0] }}\n", end)),
                                  {1, kernels::widest_supported()});
    EXPECT_NEAR(loaded_area(bar), 0.3 + 2.2e-3, 0.01 * 0.3) << side;
  }
}

// Facets beside edges may be slivers, whose sides do not span their planes: forces were not finite.
TEST(loads, of_pressures_on_slivers_are_finite) {
  const std::string bar = tests::with(tests::with(free_block(3), "[1, 1, 1]", "[3.07, 1, 1.1]"),
                                      "spacing = 0.125", "spacing = \"1/6\"");
  LagrangianSolver<3> solver(tests::read_text(bar + R"([[boundary]]
name = "pull"
kind = "pressure"
pressure = -0.01
geometry = { shape = "half_space", normal = [-1, 0, 0], point = [3.069, 0, 0] }
)"),
                             {1, kernels::widest_supported()});
  for (int i = 0; i < 30; ++i) solver.step(HUGE_VAL);
  const double momentum = solver.integrals().momentum[0];
  EXPECT_NEAR(momentum, 0.011 * solver.clock().time, 0.02 * momentum);
}

// Gravity that varies about a point as a linear spring: the body swings as a whole.
TEST(loads, gravity_can_depend_on_place_and_time) {
  const Case settings = tests::read_text("gravity = [\"-4*(x - 0.5)\", \"6*t\"]\n" + free_block(2) +
                                         "velocity = [0, 1]\n");
  LagrangianSolver<2> solver(settings, {1, kernels::widest_supported()});
  advance_until(solver, 0.5);
  const BodyIntegrals sum = solver.integrals();
  EXPECT_NEAR(sum.first_moment[0] / sum.mass, 0.5, 1e-12);
  EXPECT_NEAR(sum.first_moment[1] / sum.mass, 0.5 + 0.5 + 0.125, 1e-3);
}

// Uniaxial strain: the stress is rho g (L - y), and the top sinks by rho g L^2/(2 M).
TEST(loads, a_column_sinks_under_its_weight_as_far_as_it_should_and_rests_on_it) {
  const std::string walls = half_space("left", "kind = \"slip_wall\"\n", "[0, 0]", "[1, 0]") +
                            half_space("right", "kind = \"slip_wall\"\n", "[1, 0]", "[-1, 0]") +
                            half_space("floor", "kind = \"fixed\"\n", "[0, 0]", "[0, 1]");
  const Case settings = tests::read_text(
      "gravity = [0, -0.01]\n" + free_block(2) + walls +
          measurement("force", "kind = \"wall_force\"\nboundary = \"floor\"\naxis = \"y\"\n") +
          measurement("middle",
                      "kind = \"material_value\"\npoint = [0.5, 0.5]\nfield = "
                      "\"stress_yy\"\n"),
      {"total_lagrangian.damping=20"});
  LagrangianSolver<2> solver(settings, {1, kernels::widest_supported()});
  advance_until(solver, 4);
  const double stiffness = bulk_modulus + shear_modulus * 4 / 3, weight = 0.01;
  for_each_particle<2>(solver.state().bodies[0], [&](std::int64_t p, const Point<2>& x) {
    const double sunk = weight * (x[1] - x[1] * x[1] / 2) / stiffness;
    EXPECT_NEAR(solver.state().bodies[0].displacement[1][p], -sunk, 0.02 * weight / stiffness);
  });
  const double before = values(solver)["force"], start = solver.clock().time;
  take_steps(solver, 100);
  EXPECT_NEAR((values(solver)["force"] - before) / (solver.clock().time - start), weight,
              1e-6 * weight);
  EXPECT_NEAR(values(solver)["middle"], -weight / 2, 0.01 * weight);
}

// The load on one end of a bar at rest equals the force of the wall at the other end.
TEST(loads, a_dead_load_on_a_bar_is_the_reaction_of_its_wall) {
  const std::string walls = half_space("left", "kind = \"slip_wall\"\n", "[0, 0]", "[1, 0]") +
                            half_space("below", "kind = \"slip_wall\"\n", "[0, 0]", "[0, 1]");
  const std::string end = R"([[boundary]]
name = "pull"
kind = "traction"
geometry = { shape = "box", lower = [0.999, -9], upper = [9, 9] }
traction = [10, 0]
)";
  const std::string measurements =
      measurement("reaction", "kind = \"wall_force\"\nboundary = \"left\"\naxis = \"x\"\n") +
      measurement("stress",
                  "kind = \"material_value\"\npoint = [0.5, 0.5]\nfield = "
                  "\"stress_xx\"\n") +
      measurement("across", "kind = \"mean_value\"\nfield = \"stress_yy\"\nwhere = \"x > 0.2\"\n") +
      measurement("out", "kind = \"material_value\"\npoint = [0.2, 0.1]\nfield = \"stress_zz\"\n") +
      measurement("mises",
                  "kind = \"material_value\"\npoint = [0.9, 0.5]\nfield = "
                  "\"von_mises_stress\"\n") +
      measurement("strain_x",
                  "kind = \"material_value\"\npoint = [0.4, 0.5]\nfield = "
                  "\"strain_xx\"\n") +
      measurement("mean_strain_x", "kind = \"mean_value\"\nfield = \"strain_xx\"\n") +
      measurement("fixed_strain_x",
                  "kind = \"point_value\"\npoint = [0.4, 0.5]\nfield = \"strain_xx\"\n") +
      measurement("end", "kind = \"point_displacement\"\npoint = [1, 0.5]\naxis = \"x\"\n") +
      measurement("width", "kind = \"point_displacement\"\npoint = [0.5, 1]\naxis = \"y\"\n") +
      measurement("centre", "kind = \"centre_of_mass\"\naxis = \"x\"\n");
  for (const bool dead : {true, false}) {
    const Case settings = tests::read_text(
        free_block(2) + walls + end + (dead ? "area = \"undeformed\"\n" : "") + measurements,
        {"total_lagrangian.damping=10"});
    LagrangianSolver<2> solver(settings, {1, kernels::widest_supported()});
    advance_until(solver, 6);
    const double before = values(solver)["reaction"], start = solver.clock().time;
    take_steps(solver, 100);
    auto at_end = values(solver);
    const double width = 1 + at_end["width"], force = dead ? 10 : 10 * width;
    EXPECT_LT(width, 0.95);
    EXPECT_NEAR((at_end["reaction"] - before) / (solver.clock().time - start), -force, 1e-5);
    EXPECT_NEAR(at_end["stress"], force / width, 1e-5);
    EXPECT_NEAR(at_end["across"], 0, 1e-5);
    for (const char* strain : {"strain_x", "mean_strain_x", "fixed_strain_x"}) {
      EXPECT_NEAR(at_end[strain], at_end["end"] + at_end["end"] * at_end["end"] / 2, 1e-7);
    }
    EXPECT_NEAR(at_end["centre"], (1 + at_end["end"]) / 2, 1e-7);
    const double x = force / width, z = at_end["out"];
    EXPECT_GT(z, 0.1 * x);
    EXPECT_NEAR(at_end["mises"], std::sqrt((x * x + z * z + (x - z) * (x - z)) / 2), 1e-4);
  }
}

// Rubber so stiff that it slides as a rigid block.
std::string stiff_block(const std::string& friction) {
  std::string text = tests::with(free_block(2), "[10]", "[1e4]");
  text = tests::with(text, "0.05", "5e-5");
  return text + "[[boundary]]\nname = \"plane\"\nkind = \"contact_wall\"\nfriction = " + friction +
         "\ngeometry = { shape = \"half_space\", point = [0, 0], normal = [0, 1] }\n" +
         measurement("force", "kind = \"wall_force\"\nboundary = \"plane\"\naxis = \"y\"\n") +
         measurement("drag", "kind = \"wall_force\"\nboundary = \"plane\"\naxis = \"x\"\n");
}

// A plane tilted by 30 degrees, in the frame of the plane: a = g (sin - mu cos).
TEST(contact_walls, a_block_slides_down_a_tilted_plane_as_coulomb_says) {
  for (const double friction : {0., 0.3, 0.8}) {
    const Case settings =
        tests::read_text("gravity = [\"9.81*sin(pi/6)\", \"-9.81*cos(pi/6)\"]\n" +
                             stiff_block(std::to_string(friction)),
                         {"total_lagrangian.damping=0", "discretisation.spacing=0.25"});
    LagrangianSolver<2> solver(settings, {1, kernels::widest_supported()});
    advance_until(solver, 0.4);
    const double t = solver.clock().time, normal = 9.81 * std::cos(std::numbers::pi / 6);
    const double a = std::max(0., 9.81 * 0.5 - friction * normal);
    const BodyIntegrals sum = solver.integrals();
    EXPECT_NEAR(sum.first_moment[0] / sum.mass - 0.5, a * t * t / 2, 0.02 * 9.81 * t * t / 2);
    EXPECT_NEAR(values(solver)["force"] / t, normal, 0.02 * normal);
    EXPECT_NEAR(values(solver)["drag"] / t, a - 9.81 * 0.5, 0.02 * normal);
    const double way = a * t * t / 2, fall = 9.81 * 0.5 * t * t / 2;
    EXPECT_NEAR(solver.energy_budget()->friction, friction * sum.mass * normal * way,
                0.02 * sum.mass * normal * fall);
  }
}

// The lowest point of a disc that is pressed into a block makes a dent of the same depth.
TEST(contact_walls, an_indenter_of_any_shape_stays_outside_the_body) {
  const std::string text =
      free_block(2) + half_space("floor", "kind = \"fixed\"\n", "[0, 0]", "[0, 1]") +
      R"([[boundary]]
name = "ball"
kind = "contact_wall"
displacement = [0, "-0.1*t"]
geometry = { shape = "disc", centre = [0.5, 1.5], radius = 0.5 }
)" + measurement("force", "kind = \"wall_force\"\nboundary = \"ball\"\naxis = \"y\"\n") +
      measurement("dent", "kind = \"point_displacement\"\npoint = [0.5, 1]\naxis = \"y\"\n");
  const Case settings =
      tests::read_text(text, {"total_lagrangian.damping=2", "discretisation.spacing=0.0625"});
  LagrangianSolver<2> solver(settings, {1, kernels::widest_supported()});
  advance_until(solver, 1);
  EXPECT_NEAR(values(solver)["dent"], -0.1, 1e-3);
  EXPECT_LT(values(solver)["force"], 0);
  const auto& body = solver.state().bodies[0];
  for_each_particle<2>(body, [&](std::int64_t p, const Point<2>& x) {
    const double dx = x[0] + body.displacement[0][p] - 0.5;
    const double dy = x[1] + body.displacement[1][p] - 1.4;
    // The mean of a facet is outside; h^2/(4 R) is 2e-3 m.
    EXPECT_GT(std::hypot(dx, dy), 0.5 - 2e-3);
  });
  EXPECT_GT(solver.energy_budget()->wall_work, 0);
  EXPECT_LT(balance(solver), 0.02 * solver.energy_budget()->wall_work);
}

// A wall that pulls for a while and then stops: its work is what the bar holds and has lost.
TEST(energy_budget, the_work_of_a_wall_is_in_the_bar_or_was_damped) {
  const std::string walls =
      half_space("left", "kind = \"fixed\"\n", "[0, 0]", "[1, 0]") +
      half_space("right", "kind = \"moving_wall\"\nvelocity = [\"t < 0.3 ? 1 : 0\", 0]\n", "[1, 0]",
                 "[-1, 0]");
  for (const char* damping : {"0", "3"}) {
    const Case settings = tests::read_text(free_block(2) + walls,
                                           {std::string("total_lagrangian.damping=") + damping});
    LagrangianSolver<2> solver(settings, {1, kernels::widest_supported()});
    advance_until(solver, 0.8);
    const double work = solver.energy_budget()->wall_work;
    EXPECT_GT(work, 1);
    EXPECT_NEAR(balance(solver), 0, 0.01 * work);
    if (damping[0] != '0') {
      EXPECT_GT(solver.energy_budget()->damping, 0.01 * work);
    }
  }
}

TEST(energy_budget, the_work_of_loads_and_gravity_is_in_the_bar) {
  const Case settings = tests::read_text(
      "gravity = [0, -3]\n" + free_block(2) +
      half_space("floor", "kind = \"fixed\"\n", "[0, 0]", "[0, 1]") + R"toml([[boundary]]
name = "pull"
kind = "traction"
geometry = { shape = "box", lower = [-9, 0.999], upper = [9, 9] }
traction = ["5*sin(3*t)", 4]
[[boundary]]
name = "push"
kind = "pressure"
geometry = { shape = "box", lower = [0.999, 0.3], upper = [9, 9] }
pressure = 3
)toml");
  LagrangianSolver<2> solver(settings, {1, kernels::widest_supported()});
  advance_until(solver, 0.8);
  const EnergyBudget budget = *solver.energy_budget();
  EXPECT_GT(budget.load_work, 0.05);
  EXPECT_NEAR(balance(solver), 0, 0.01 * budget.load_work);
}

// The block sinks by its strain under its weight, and swings about that.
TEST(energy_budget, gravity_does_work_on_a_block_on_a_contact_wall_as_far_as_it_sinks) {
  const Case settings = tests::read_text(
      "gravity = [0, -9.81]\n" + tests::with(stiff_block("0.3"), "[1e4]", "[200]") +
          measurement("height", "kind = \"centre_of_mass\"\naxis = \"y\"\n"),
      {"total_lagrangian.damping=0"});
  LagrangianSolver<2> solver(settings, {1, kernels::widest_supported()});
  const double start = values(solver)["height"], mass = solver.integrals().mass;
  advance_until(solver, 1);
  const double expected = 9.81 * mass * (start - values(solver)["height"]);
  EXPECT_GT(expected, 0);
  EXPECT_NEAR(solver.energy_budget()->body_force_work, expected, 0.02 * expected);
}

}  // namespace
}  // namespace pliant::test

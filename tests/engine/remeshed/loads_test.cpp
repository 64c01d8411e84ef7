#include <gtest/gtest.h>

#include "tests/engine/case/written_case.hpp"
#include "tests/engine/remeshed/small_case.hpp"
#include "tests/engine/undeformed/loads.hpp"

// Gravity, damping, tractions, reactions and the energy balance, against solutions in closed form.
namespace pliant::test {
namespace {

// A block [0, 1] x [0, 1] that waves cross in 0.086 s.
constexpr double youngs_modulus = 200, poissons_ratio = 0.3, density = 2;
constexpr double uniaxial =
    youngs_modulus * (1 - poissons_ratio) / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio));

const std::string block = R"([discretisation]
spacing = 0.1
[time]
end = 10
[[body]]
name = "block"
geometry = { shape = "box", lower = [0, 0], upper = [1, 1] }
material = { model = "linear", youngs_modulus = 200, poissons_ratio = 0.3, density = 2 }
)";

/// The mean of the measurement `reaction`, a force of a wall, over 20 steps [N/m].
double mean_reaction(Solver& solver) {
  const double before = values(solver)["reaction"], start = solver.clock().time;
  advance(solver, 20);
  return (values(solver)["reaction"] - before) / (solver.clock().time - start);
}

TEST(body_forces, free_fall_is_exact) {
  const Case settings =
      tests::read_text("gravity = [0.5, \"-9.81*t\"]\n" + block, {"remeshing.every=5"});
  Solver solver(settings, {1, kernels::widest_supported()});
  advance_until(solver, 0.1);
  const double t = solver.clock().time;
  const auto& body = solver.state().bodies[0];
  for_each(body.population, Kind::interior, [&](std::int64_t p, const Cell<2>&) {
    EXPECT_NEAR(body.stage[0].get(Field::velocity, 0)[p], 0.5 * t, 1e-9);
    EXPECT_NEAR(body.stage[0].get(Field::velocity, 1)[p], -9.81 * t * t / 2, 1e-9);
  });
  const EnergyBudget budget = *solver.energy_budget();
  const double speed2 = 0.25 * t * t + std::pow(9.81 * t * t / 2, 2);
  EXPECT_NEAR(budget.body_force_work, density * speed2 / 2, 1e-3 * density * speed2);
}

TEST(body_forces, damping_slows_a_body_exponentially) {
  const Case settings = tests::read_text(block + "velocity = [1, 0]\n",
                                         {"remeshing.every=5", "discretisation.damping=4"});
  Solver solver(settings, {1, kernels::widest_supported()});
  advance_until(solver, 0.2);
  const auto& body = solver.state().bodies[0];
  for_each(body.population, Kind::interior, [&](std::int64_t p, const Cell<2>&) {
    EXPECT_NEAR(body.stage[0].get(Field::velocity, 0)[p], std::exp(-0.8), 1e-6);
  });
  // The energy is an integral over cells, some of which the surface cuts; the loss is a sum over
  // particles.
  EXPECT_NEAR(balance(solver), density / 2, 3e-3 * density);
}

// Uniaxial strain: the stress is rho g (L - y).
TEST(body_forces, a_column_carries_its_weight_and_rests_on_its_floor) {
  const std::string walls = half_space("left", "kind = \"slip_wall\"\n", "[0, 0]", "[1, 0]") +
                            half_space("right", "kind = \"slip_wall\"\n", "[1, 0]", "[-1, 0]") +
                            half_space("floor", "kind = \"fixed\"\n", "[0, 0]", "[0, 1]");
  const Case settings = tests::read_text(
      "gravity = [0, -0.1]\n" + block + walls +
          measurement("force", "kind = \"wall_force\"\nboundary = \"floor\"\naxis = \"y\"\n") +
          measurement("stress",
                      "kind = \"material_value\"\npoint = [0.5, 0.5]\nfield = "
                      "\"stress_yy\"\n") +
          measurement("top", "kind = \"point_displacement\"\npoint = [0.5, 1]\naxis = \"y\"\n"),
      {"discretisation.damping=30"});
  Solver solver(settings, {1, kernels::widest_supported()});
  advance_until(solver, 1);
  const double weight = 0.1 * density, before = values(solver)["force"],
               start = solver.clock().time;
  advance(solver, 20);
  const double force = (values(solver)["force"] - before) / (solver.clock().time - start);
  EXPECT_NEAR(force, weight, 0.03 * weight);
  EXPECT_NEAR(values(solver)["stress"], -weight / 2, 0.03 * weight);
  EXPECT_NEAR(values(solver)["top"], -weight / 2 / uniaxial, 0.03 * weight / uniaxial);
}

TEST(tractions, a_pulled_bar_has_the_stress_of_the_traction_and_pulls_at_its_wall) {
  const std::string walls = half_space("left", "kind = \"slip_wall\"\n", "[0, 0]", "[1, 0]") +
                            half_space("below", "kind = \"slip_wall\"\n", "[0, 0]", "[0, 1]");
  const Case settings = tests::read_text(
      block + walls + R"([[boundary]]
name = "pull"
kind = "traction"
geometry = { shape = "box", lower = [0.99, -9], upper = [9, 9] }
traction = [1, 0]
)" + measurement("reaction", "kind = \"wall_force\"\nboundary = \"left\"\naxis = \"x\"\n") +
          measurement("stress",
                      "kind = \"material_value\"\npoint = [0.5, 0.4]\nfield = "
                      "\"stress_xx\"\n") +
          measurement("mean",
                      "kind = \"mean_value\"\nfield = \"stress_xx\"\nwhere = \"x > 0.3\"\n") +
          measurement("out",
                      "kind = \"material_value\"\npoint = [0.5, 0.4]\nfield = "
                      "\"stress_zz\"\n") +
          measurement("mises",
                      "kind = \"material_value\"\npoint = [0.5, 0.4]\nfield = "
                      "\"von_mises_stress\"\n") +
          measurement("strain",
                      "kind = \"material_value\"\npoint = [0.5, 0.4]\nfield = "
                      "\"strain_xx\"\n") +
          measurement("mean_strain",
                      "kind = \"mean_value\"\nfield = \"strain_xx\"\nwhere = \"x > 0.3\"\n") +
          measurement("fixed_point",
                      "kind = \"point_value\"\npoint = [0.5, 0.4]\nfield = \"strain_yy\"\n") +
          measurement("centre", "kind = \"centre_of_mass\"\naxis = \"x\"\nreference = 0.5\n"),
      {"discretisation.damping=20"});
  Solver solver(settings, {1, kernels::widest_supported()});
  advance_until(solver, 1);
  const double reaction = mean_reaction(solver);
  auto at_end = values(solver);
  const double pull = 1.01;  // the region has 0.01 m of the upper side
  const double strain = pull * (1 - poissons_ratio * poissons_ratio) / youngs_modulus;
  EXPECT_NEAR(reaction, -pull, 0.03);
  EXPECT_NEAR(at_end["stress"], pull, 0.02);
  EXPECT_NEAR(at_end["mean"], pull, 0.02);
  EXPECT_NEAR(at_end["out"], pull * poissons_ratio, 0.02);
  EXPECT_NEAR(at_end["mises"], pull * std::sqrt(1 - 0.3 + 0.09), 0.02);
  EXPECT_NEAR(at_end["strain"], strain, 0.03 * strain);
  EXPECT_NEAR(at_end["mean_strain"], strain, 0.03 * strain);
  const double across = -pull * poissons_ratio * (1 + poissons_ratio) / youngs_modulus;
  EXPECT_NEAR(at_end["fixed_point"], across, -0.03 * across);
  EXPECT_NEAR(at_end["centre"], strain / 2, 0.003 * 0.1);  // [h], as the surface is within a cell
}

// The region stays behind, but the load moves with the block and keeps pushing it down.
TEST(pressures, follow_the_surface_out_of_their_region) {
  const Case settings = tests::read_text(block + R"(velocity = [4, 0]
[[boundary]]
name = "load"
kind = "pressure"
geometry = { shape = "box", lower = [-0.5, 0.9], upper = [1.5, 2] }
pressure = 1
)",
                                         {"remeshing.every=5"});
  Solver solver(settings, {1, kernels::widest_supported()});
  advance_until(solver, 0.5);
  EXPECT_NEAR(solver.integrals().momentum[1], -0.5, 0.02);
}

TEST(tractions, shear_on_the_top_of_a_block_is_the_reaction_of_its_floor) {
  const Case settings = tests::read_text(
      block + half_space("floor", "kind = \"fixed\"\n", "[0, 0]", "[0, 1]") + R"([[boundary]]
name = "drag"
kind = "traction"
geometry = { shape = "box", lower = [-9, 0.99], upper = [9, 9] }
traction = [0.5, 0]
)" + measurement("reaction", "kind = \"wall_force\"\nboundary = \"floor\"\naxis = \"x\"\n"),
      {"discretisation.damping=10"});
  Solver solver(settings, {1, kernels::widest_supported()});
  advance_until(solver, 1.5);
  EXPECT_NEAR(mean_reaction(solver), -0.5, 0.05);
}

// The impulse of a shear traction on one end of a free bar, and its moment about the middle. In 2D
// and 3D, at places between and on the nodes of the lattice.
TEST(tractions, shear_on_the_end_of_a_bar_has_the_impulse_of_that_end_and_its_moment) {
  for (const std::string spacing : {"0.2/5", "0.2/6.6", "0.2/8", "0.2/10"}) {
    const Case settings = tests::read_text(R"toml(
[time]
end = 1
[[body]]
name = "bar"
geometry = { shape = "box", lower = [0, -0.1], upper = [0.6, 0.1] }
material = { model = "linear", youngs_modulus = 100, poissons_ratio = 0.3, density = 1 }
[[boundary]]
name = "end"
kind = "traction"
traction = [0, "0.1*min(t/0.15, 1)"]
geometry = { shape = "box", lower = [0.599, -1], upper = [2, 1] }
[discretisation]
)toml" + ("spacing = \"" + spacing) + "\"\n");
    Solver solver(settings, {1, kernels::widest_supported()});
    advance_until(solver, 0.3);
    const BodyIntegrals sum = solver.integrals();
    const double impulse = 0.1 * 0.202 * 0.225;  // the region has 0.001 m of each side
    const double moment = sum.angular_momentum[2] - 0.3 * sum.momentum[1];
    EXPECT_NEAR(sum.momentum[1], impulse, 0.012 * impulse) << spacing;
    EXPECT_NEAR(moment, 0.3 * impulse, 0.06 * 0.3 * impulse) << spacing;
  }
}

// Facets on which the region ends bear their share of the load.
TEST(tractions, act_on_the_part_of_a_face_that_is_in_their_region) {
  for (const char* spacing : {"1/8", "1/10", "1/13"}) {
    const Case settings = tests::read_text(
        R"(discretisation = { damping = "adaptive" }
time = { end = 10 }
[[body]]
name = "block"
geometry = { shape = "box", lower = [0, 0], upper = [2, 1] }
material = { model = "linear", youngs_modulus = 200, poissons_ratio = 0.3, density = 2 }
)" + half_space("floor", "kind = \"fixed\"\n", "[0, 0]", "[0, 1]") +
            R"toml([[boundary]]
name = "drag"
kind = "traction"
geometry = { shape = "box", lower = [0.61, 0.99], upper = [1.38, 9] }
traction = ["min(t, 1)", 0]
)toml" + measurement("reaction", "kind = \"wall_force\"\nboundary = \"floor\"\naxis = \"x\"\n"),
        {std::string("discretisation.spacing=\"") + spacing + "\""});
    Solver solver(settings, {1, kernels::widest_supported()});
    advance_until(solver, 3);
    EXPECT_NEAR(mean_reaction(solver), -0.77, 0.01 * 0.77) << spacing;
  }
}

// The edges of the loaded face bear the stress of its middle. It was 1.02 and 0.97 of the pressure,
// and the energy balance warned.
TEST(pressures, press_a_cube_alike_at_its_edges) {
  for (const char* spacing : {"0.2/5", "0.2/6.4"}) {
    const Case settings = tests::read_text(
        R"(dimension = 3
discretisation = { damping = "adaptive" }
time = { end = 2 }
[[body]]
name = "cube"
geometry = { shape = "box", lower = [0, 0, 0], upper = [0.2, 0.2, 0.2] }
material = { model = "linear", youngs_modulus = 100, poissons_ratio = 0.3, density = 1 }
)" + half_space("floor", "kind = \"slip_wall\"\n", "[0, 0, 0]", "[0, 0, 1]") +
            R"toml([[boundary]]
name = "load"
kind = "pressure"
geometry = { shape = "box", lower = [-9, -9, 0.199], upper = [9, 9, 9] }
pressure = "2*min(t/0.5, 1)"
)toml" + measurement("along", "kind = \"mean_value\"\nfield = \"stress_zz\"\n") +
            measurement("across", "kind = \"mean_value\"\nfield = \"stress_xx\"\n"),
        {std::string("discretisation.spacing=\"") + spacing + "\""});
    remeshed::Solver<double, 3> solver(settings, {2, kernels::widest_supported()});
    advance_until(solver, 1.5);
    const std::vector<double> stress = solver.measure();
    EXPECT_NEAR(stress[0], -2, 0.005 * 2) << spacing;
    EXPECT_NEAR(stress[1], 0, 0.005 * 2) << spacing;
    const BodyIntegrals sum = solver.integrals();
    const EnergyBudget budget = *solver.energy_budget();
    EXPECT_NEAR(sum.strain_energy + budget.damping, budget.work(), 0.04 * budget.work()) << spacing;
  }
}

// The region ends in the plane of the face: all of its ghosts must bear the load, whose work must
// be in the energy balance. When rounding decided for each ghost, the run created all of its
// energy.
TEST(tractions, act_on_a_face_on_which_their_region_ends) {
  const Case settings = tests::read_text(
      R"(dimension = 3
discretisation = { spacing = 0.05, damping = "adaptive" }
time = { end = 10 }
[[body]]
name = "bar"
geometry = { shape = "box", lower = [0, 0, 0], upper = [0.4, 0.25, 0.25] }
material = { model = "linear", youngs_modulus = 200, poissons_ratio = 0.3, density = 2 }
)" + half_space("left", "kind = \"slip_wall\"\n", "[0, 0, 0]", "[1, 0, 0]") +
      R"toml([[boundary]]
name = "pull"
kind = "traction"
geometry = { shape = "box", lower = [0.4, -9, -9], upper = [9, 9, 9] }
traction = ["min(t/0.3,1)", 0, 0]
)toml" +
      measurement("stress", "kind = \"mean_value\"\nfield = \"stress_xx\"\nwhere = \"x < 0.2\"\n"));
  remeshed::Solver<double, 3> solver(settings, {2, kernels::widest_supported()});
  advance_until(solver, 0.4);
  EXPECT_NEAR(solver.measure()[0], 1, 0.04);
  const BodyIntegrals sum = solver.integrals();
  const EnergyBudget budget = *solver.energy_budget();
  const double stored = sum.kinetic_energy + sum.strain_energy;
  EXPECT_NEAR(stored + budget.damping, budget.work(), 0.1 * budget.work());
}

// Loads, and walls that pull for a while and stop: their work must be in the bar.
TEST(energy_budget_of_the_remeshed_method, work_is_in_the_bar) {
  const std::string walls =
      half_space("left", "kind = \"fixed\"\n", "[0, 0]", "[1, 0]") +
      half_space("right", "kind = \"moving_wall\"\nvelocity = [\"0.2*(1 - cos(20*pi*t))\", 0]\n",
                 "[1, 0]", "[-1, 0]") +
      R"([[boundary]]
name = "push"
kind = "pressure"
geometry = { shape = "box", lower = [-9, 0.99], upper = [9, 9] }
pressure = 4
)";
  const Case settings = tests::read_text(block + walls, {"discretisation.spacing=0.05"});
  Solver solver(settings, {1, kernels::widest_supported()});
  advance_until(solver, 0.1);
  const EnergyBudget budget = *solver.energy_budget();
  EXPECT_GT(budget.wall_work, 0.01);
  EXPECT_GT(budget.load_work, 0.005);
  EXPECT_NEAR(balance(solver), 0, 0.05 * budget.work());
}

}  // namespace
}  // namespace pliant::test

#include <gtest/gtest.h>

#include <algorithm>

#include <fmt/format.h>

#include "tests/engine/case/written_case.hpp"
#include "tests/engine/remeshed/small_case.hpp"
#include "tests/engine/undeformed/loads.hpp"

// Plane bodies under a constant load, or between walls at rest, come to rest and stay at rest.
namespace pliant::test {
namespace {

/// Measurements at the end, with `wall_force` averaged over the last second.
std::vector<double> values_at(Solver& solver, double end) {
  advance_until(solver, end - 1);
  const std::vector<double> before = solver.measure();
  const double start = solver.clock().time;
  advance_until(solver, end);
  std::vector<double> now = solver.measure();
  for (std::size_t m = 0; m < now.size(); ++m) {
    if (solver.settings().measurements[m].kind != MeasurementCase::Kind::wall_force) continue;
    now[m] = (now[m] - before[m]) / (solver.clock().time - start);
  }
  return now;
}

// Eight particles across. The ring used to creep by a tenth in 8 s, with energy growing from
// nothing. The displacement is Lame's in plane strain, u = (1 + nu)/E A ((1 - 2 nu) r + b^2/r) with
// A = p a^2/(b^2 - a^2); the steps of the lattice at the inner surface cause errors of 3 %.
TEST(held_bodies, a_thick_ring_under_pressure_does_not_creep) {
  const Case settings = tests::read_text(R"toml(dimension = 2
discretisation = { spacing = 0.0625, damping = "adaptive" }
time = { end = 12 }
[[body]]
name = "ring"
geometry = { shape = "difference", of = [{ shape = "disc", centre = [0, 0], radius = 1 },
                                         { shape = "disc", centre = [0, 0], radius = 0.5 }] }
material = { model = "linear", youngs_modulus = 100, poissons_ratio = 0.3, density = 1 }
[[boundary]]
name = "inner"
kind = "pressure"
pressure = "0.2*min(t, 1)"
geometry = { shape = "disc", centre = [0, 0], radius = 0.75 }
[[measurement]]
name = "outward"
kind = "point_displacement"
point = [0.98, 0]
)toml");
  Solver solver(settings, {1, kernels::widest_supported()});
  const double r = 0.98, scale = 1.3 / 100 * 0.2 * 0.25 / 0.75;
  const double exact = scale * (0.4 * r + 1 / r);
  const double early = values_at(solver, 4)[0], late = values_at(solver, 12)[0];
  EXPECT_NEAR(early / exact, 1, 0.04);
  EXPECT_NEAR(late / early, 1, 0.002);
}

// The corners used to slip out of the wall, and the block tore off. The reference is the total
// Lagrangian method with 20 cells across.
TEST(held_bodies, a_block_stays_on_walls_that_stretch_it_by_half) {
  const Case settings = tests::read_text(R"toml(dimension = 2
discretisation = { spacing = 0.05, damping = "adaptive" }
time = { end = 3 }
[[body]]
name = "block"
geometry = { shape = "box", lower = [0, 0], upper = [1, 2] }
material = { model = "reduced_polynomial", coefficients = ["100/5.8"], compressibility = 0.006, density = 1 }
[[boundary]]
name = "floor"
kind = "fixed"
geometry = { shape = "half_space", point = [0, 0], normal = [0, 1] }
[[boundary]]
name = "piston"
kind = "moving_wall"
displacement = [0, "min(t/2, 1)"]
geometry = { shape = "half_space", point = [0, 2], normal = [0, -1] }
[[measurement]]
name = "force"
kind = "wall_force"
boundary = "floor"
axis = "y"
[[measurement]]
name = "flank"
kind = "point_displacement"
point = [1, 1]
[[measurement]]
name = "energy"
kind = "strain_energy"
)toml");
  Solver solver(settings, {2, kernels::widest_supported()});
  const std::vector<double> end = values_at(solver, 3);
  EXPECT_NEAR(end[0], -41.2, 0.05 * 41.2);
  EXPECT_NEAR(end[1], -0.1554, 0.02 * 0.1554);
  EXPECT_NEAR(end[2], 23.92, 0.03 * 23.92);
}

// A block on a frictionless wall under its weight. The wall used to carry 1.033 of it after 20 s,
// and the block to sink by 4 % between 7 and 20 s.
TEST(held_bodies, a_block_stands_on_a_slip_wall_with_its_weight) {
  const Case settings = tests::read_text(R"toml(dimension = 2
gravity = [0, "-5*min(t, 1)"]
discretisation = { spacing = 0.04, damping = 1 }
time = { end = 20 }
[[body]]
name = "block"
geometry = { shape = "box", lower = [0, 0], upper = [0.4, 0.4] }
material = { model = "linear", youngs_modulus = 100, poissons_ratio = 0.3, density = 1 }
[[boundary]]
name = "floor"
kind = "slip_wall"
geometry = { shape = "half_space", point = [0, 0], normal = [0, 1] }
[[measurement]]
name = "force"
kind = "wall_force"
boundary = "floor"
axis = "y"
[[measurement]]
name = "top"
kind = "point_displacement"
point = [0.2, 0.38]
axis = "y"
)toml");
  Solver solver(settings, {1, kernels::widest_supported()});
  const double early = values_at(solver, 8)[1];
  const std::vector<double> late = values_at(solver, 20);
  EXPECT_NEAR(late[0] / (5 * 0.16), 1, 0.01);
  EXPECT_NEAR(late[1] / early, 1, 0.005);
}

// A beam of 48 m by 8 m, 8 particles across, that is clamped at one end.
Case clamped_beam(double end, const std::string& gravity, const std::string& load) {
  return tests::read_text("dimension = 2\n" + gravity + fmt::format("time.end = {}\n", end) +
                          R"toml(discretisation = { spacing = 1, damping = 0.02 }
[[body]]
name = "beam"
geometry = { shape = "box", lower = [0, 0], upper = [48, 8] }
material = { model = "linear", youngs_modulus = 250, poissons_ratio = 0.3, density = 1 }
[[boundary]]
name = "clamp"
kind = "fixed"
geometry = { shape = "half_space", point = [0, 0], normal = [1, 0] }
[[measurement]]
name = "deflection"
kind = "point_displacement"
point = [48, 4]
axis = "y"
[[measurement]]
name = "force"
kind = "wall_force"
boundary = "clamp"
axis = "y"
)toml" + load);
}

Case loaded_beam(double end) {
  return clamped_beam(end, "", R"toml([[boundary]]
name = "load"
kind = "traction"
traction = [0, "0.00625*min(t/200, 1)"]
geometry = { shape = "box", lower = [47.99, -1], upper = [50, 9] }
)toml");
}

// The total Lagrangian method gives 0.1597 m, and converges to it.
TEST(held_bodies, bend_under_tractions_as_they_should) {
  const Case slow = loaded_beam(600);
  ASSERT_EQ(warnings_of_method(slow).size(), 1u);
  EXPECT_NE(warnings_of_method(slow)[0].find("faces under tractions"), std::string::npos);
  remeshed::Solver<double, 2> solver(slow, {2, kernels::widest_supported()});
  const std::vector<double> found = values_at(solver, 600);
  EXPECT_NEAR(found[0], 0.1597, 0.015 * 0.1597);
  EXPECT_NEAR(found[1], -0.05, 2e-3 * 0.05);
}

// With 16 and 25 across they move by 34 and 7 % of the largest displacement too little or too far.
TEST(held_bodies, are_warned_of_if_they_are_round_and_bear_tractions) {
  const auto warns = [](const std::string& kind, const std::string& spacing) {
    const std::vector<std::string> warnings = warnings_of_method(tests::read_text(
        R"toml(method = "remeshed"
time.end = 1
discretisation.spacing = ")toml" +
        spacing + R"toml("
[[body]]
name = "disc"
geometry = { shape = "disc", centre = [0.5, 0.5], radius = 0.5 }
material = { model = "neo_hookean", density = 1, youngs_modulus = 1000, poissons_ratio = 0.3 }
[[boundary]]
name = "load"
geometry = { shape = "box", lower = [0.3, 0.55], upper = [0.75, 9] }
)toml" + kind));
    return std::ranges::any_of(warnings, [](const std::string& warning) {
      return warning.find("under tractions on its round parts") != std::string::npos;
    });
  };
  const std::string traction = "kind = \"traction\"\ntraction = [1, 0]\n";
  EXPECT_TRUE(warns(traction, "1/16"));
  EXPECT_TRUE(warns(traction, "1/25"));
  EXPECT_FALSE(warns(traction, "1/28"));
  EXPECT_FALSE(warns("kind = \"pressure\"\npressure = 1\n", "1/16"));
}

/// A round body of 1 m on slip walls that cut it at `height` along each axis.
std::string leaning_body(int dimension, int across, double height) {
  std::string text = fmt::format(
      "dimension = {}\ntime.end = 8\ndiscretisation = {{ spacing = \"1/{}\", damping = "
      "\"adaptive\" "
      "}}\n[[body]]\nname = \"round\"\nmaterial = {{ model = \"neo_hookean\", density = 1, "
      "youngs_modulus = 10, poissons_ratio = 0.3 }}\n",
      dimension, across);
  text += dimension == 2
              ? "geometry = { shape = \"disc\", centre = [0.5, 0.5], radius = 0.5 }\n"
              : "geometry = { shape = \"ball\", centre = [0.5, 0.5, 0.5], radius = 0.5 }\n";
  for (int a = 0; a < dimension; ++a) {
    const std::string z = dimension == 3 ? fmt::format(", {}", height) : "";
    const std::string normal =
        dimension == 3 ? fmt::format("[{}, {}, {}]", int(a == 0), int(a == 1), int(a == 2))
                       : fmt::format("[{}, {}]", int(a == 0), int(a == 1));
    text += half_space(fmt::format("wall_{}", a), "kind = \"slip_wall\"",
                       fmt::format("[{0}, {0}{1}]", height, z), normal);
  }
  return text;
}

// They move 0.55 to 0.9 as far as they should with 8 to 32 across.
TEST(held_bodies, are_warned_of_if_they_lean_over_slip_walls) {
  const auto warns = [](int across, double height) {
    const auto warnings = warnings_of_method(tests::read_text(leaning_body(2, across, height)));
    return std::ranges::any_of(warnings, [](const std::string& warning) {
      return warning.find("leans over a wall") != std::string::npos;
    });
  };
  EXPECT_TRUE(warns(10, 0.1));
  EXPECT_TRUE(warns(32, 0.1));
  EXPECT_FALSE(warns(36, 0.1));
  EXPECT_FALSE(warns(10, 0.3));
}

// The surface and its image in the wall meet in a re-entrant corner. The fits there created energy,
// so that the body never came to rest.
TEST(held_bodies, that_lean_over_slip_walls_come_to_rest) {
  const std::string gravity =
      "gravity = [\"0.2*min(t/4, 1)\", \"-0.1*min(t/4, 1)\", "
      "\"-0.3*min(t/4, 1)\"]\n";
  const std::vector<double> energy = values_at_end<3>(
      gravity + leaning_body(3, 12, 0.2) + measurement("kinetic", "kind = \"kinetic_energy\"\n") +
      measurement("strain", "kind = \"strain_energy\"\n"));
  EXPECT_LT(energy[0], 1e-4 * energy[1]);
}

TEST(held_bodies, meet_too_little_force_between_walls_if_they_are_thin) {
  const std::string wall = R"toml([[boundary]]
name = "other"
kind = "moving_wall"
displacement = [0, "0.1*t"]
geometry = { shape = "half_space", point = [48, 0], normal = [-1, 0] }
)toml";
  const Case thin = clamped_beam(1, "", wall);
  ASSERT_EQ(warnings_of_method(thin).size(), 1u);
  EXPECT_NE(warnings_of_method(thin)[0].find("meet up to 8 % too little force"), std::string::npos);
  Case thick = thin;
  thick.discretisation.spacing = 0.5;
  EXPECT_TRUE(warnings_of_method(thick).empty());
}

// The total Lagrangian method gives 0.1388 m with 8 particles across and 0.1390 m with 16.
TEST(held_bodies, bend_under_their_weight_as_they_should) {
  const Case settings = clamped_beam(600, "gravity = [0, \"-0.0003*min(t/200, 1)\"]\n", "");
  EXPECT_TRUE(warnings_of_method(settings).empty());
  remeshed::Solver<double, 2> solver(settings, {2, kernels::widest_supported()});
  const std::vector<double> found = values_at(solver, 600);
  EXPECT_NEAR(found[0], -0.139, 0.01 * 0.139);
  EXPECT_NEAR(found[1], 0.0003 * 384, 1e-3 * 0.0003 * 384);
}

}  // namespace
}  // namespace pliant::test

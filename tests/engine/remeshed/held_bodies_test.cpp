#include <gtest/gtest.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <numbers>

#include "tests/engine/case/written_case.hpp"
#include "tests/engine/remeshed/small_case.hpp"

// Plane linear bodies under a constant load come to rest and stay at rest.
namespace pliant::test {
namespace {

/// Measurements at the end, with `wall_force` averaged over the last second.
template <int D>
std::vector<double> values_at(remeshed::Solver<double, D>& solver, double end) {
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
TEST(held_bodies, are_bent_too_little_by_slow_tractions_which_is_warned_of) {
  const Case slow = loaded_beam(600);
  ASSERT_EQ(warnings_of_method(slow).size(), 1u);
  EXPECT_NE(warnings_of_method(slow)[0].find("up to 8 % with 8 particles across"),
            std::string::npos);
  EXPECT_TRUE(warnings_of_method(loaded_beam(30)).empty());
  remeshed::Solver<double, 2> solver(slow, {2, kernels::widest_supported()});
  const std::vector<double> found = values_at(solver, 600);
  EXPECT_NEAR(found[0], 0.1597, 0.08 * 0.1597);
  EXPECT_NEAR(found[1], -0.05, 2e-3 * 0.05);
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

/// A beam of 5 m by 1 m, clamped at one end, under a small gravity across it and with `across`
/// particles across; it lies at an angle to the lattice. In 3D it is 1 m wide.
Case inclined_beam(int dimension, int across, double degrees, double end) {
  const double angle = degrees * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
  const std::string z = dimension == 2 ? "" : ", 0";
  const auto side = [&](double along, double beside, double x, double y) {
    return fmt::format("{{ shape = \"half_space\", point = [{}, {}{}], normal = [{}, {}{}] }}",
                       along * c - beside * s, along * s + beside * c, z, x, y, z);
  };
  return tests::read_text(fmt::format(
                              R"toml(dimension = {}
gravity = ["{}*min(t/4, 1)", "{}*min(t/4, 1)"{}]
discretisation = {{ spacing = "1/{}", damping = "adaptive" }}
time.end = {}
[[body]]
name = "beam"
material = {{ model = "linear", youngs_modulus = 1000, poissons_ratio = 0.3, density = 1 }}
geometry = {{ shape = "intersection", of = [{}, {}, {}, {}, {{ shape = "box", {} }}] }}
[[boundary]]
name = "clamp"
kind = "fixed"
geometry = {}
)toml",
                              dimension, 0.02 * s, -0.02 * c, dimension == 2 ? "" : ", \"0\"",
                              across, end, side(5, 0, c, s), side(-5, 0, -c, -s),
                              side(0, 0.5, -s, c), side(0, -0.5, s, -c),
                              dimension == 2 ? "lower = [-9, -9], upper = [9, 9]"
                                             : "lower = [-9, -9, -0.5], upper = [9, 9, 0.5]",
                              side(0, 0, c, s)) +
                          fmt::format(R"toml([[measurement]]
name = "x"
kind = "point_displacement"
point = [{0}, {1}{2}]
[[measurement]]
name = "y"
kind = "point_displacement"
point = [{0}, {1}{2}]
axis = "y"
)toml",
                                      4.9 * c, 4.9 * s, z));
}

template <int D>
double bending_of_inclined_beam(int across, double degrees) {
  constexpr double end = 8;
  const Case settings = inclined_beam(D, across, degrees, end);
  remeshed::Solver<double, D> solver(settings, {2, kernels::widest_supported()});
  const std::vector<double> tip = values_at(solver, end);
  return std::hypot(tip[0], tip[1]);
}

// At these angles the particles in the corner of clamp and side used to start moving by themselves.
TEST(held_bodies, bend_alike_at_every_angle_to_the_lattice) {
  const double straight = bending_of_inclined_beam<2>(12, 0);
  for (const double degrees : {30, 40, 45}) {
    EXPECT_NEAR(bending_of_inclined_beam<2>(12, degrees), straight, 0.03 * straight) << degrees;
  }
  const double solid = bending_of_inclined_beam<3>(5, 0);
  EXPECT_NEAR(bending_of_inclined_beam<3>(5, 30), solid, 0.05 * solid);
}

// A block of 1 m between two frictionless walls at 45 degrees to the lattice, pressed by 0.1 m.
// The energy is that of the block along the lattice.
TEST(held_bodies, between_inclined_slip_walls_are_pressed_as_along_the_lattice) {
  const Case settings = tests::read_text(R"toml(dimension = 2
discretisation = { spacing = 0.1, damping = "adaptive" }
time.end = 4
[[body]]
name = "block"
material = { model = "reduced_polynomial", coefficients = [192.3], compressibility = 0.0024, density = 1 }
geometry = { shape = "intersection", of = [
  { shape = "half_space", point = [0.70711, 0.70711], normal = [1, 1] },
  { shape = "half_space", point = [0, 0], normal = [-1, -1] },
  { shape = "half_space", point = [-0.353553, 0.353553], normal = [-1, 1] },
  { shape = "half_space", point = [0.353553, -0.353553], normal = [1, -1] },
  { shape = "box", lower = [-3, -3], upper = [3, 3] }] }
[[boundary]]
name = "moving"
kind = "slip_wall"
geometry = { shape = "half_space", point = [0, 0], normal = [1, 1] }
displacement = ["0.070711*min(t/2, 1)", "0.070711*min(t/2, 1)"]
[[boundary]]
name = "resting"
kind = "slip_wall"
geometry = { shape = "half_space", point = [0.70711, 0.70711], normal = [-1, -1] }
[[measurement]]
name = "energy"
kind = "strain_energy"
)toml");
  Solver solver(settings, {2, kernels::widest_supported()});
  EXPECT_NEAR(values_at(solver, 4)[0], 5.92, 0.03 * 5.92);
}

/// A disc or ball with a hole, of radii 0.5 and 1 m, under a pressure in the hole of `pressure` Pa
/// and with 8 particles across its wall; with the planes x = 0, y = 0 (and z = 0) as planes of
/// symmetry if it is a `part`.
Case hollow_body(int dimension, const std::string& pressure, double end, bool part,
                 const std::string& measurements) {
  const std::string origin = dimension == 2 ? "[0, 0]" : "[0, 0, 0]";
  const auto ball = [&](double radius) {
    return fmt::format("{{ shape = \"{}\", centre = {}, radius = {} }}",
                       dimension == 2 ? "disc" : "ball", origin, radius);
  };
  std::string text = fmt::format(R"toml(dimension = {}
discretisation = {{ spacing = 0.0625, damping = "adaptive" }}
time.end = {}
[[body]]
name = "body"
geometry = {{ shape = "difference", of = [{}, {}] }}
material = {{ model = "linear", youngs_modulus = 1000, poissons_ratio = 0.3, density = 1 }}
[[boundary]]
name = "inner"
kind = "pressure"
pressure = "{}"
geometry = {}
)toml",
                                 dimension, end, ball(1), ball(0.5), pressure, ball(0.75));
  for (int a = 0; part && a < dimension; ++a) {
    std::vector<int> normal(dimension, 0);
    normal[a] = 1;
    text += fmt::format(R"toml([[boundary]]
name = "symmetry_{}"
kind = "slip_wall"
geometry = {{ shape = "half_space", point = {}, normal = [{}] }}
)toml",
                        a, origin, fmt::join(normal, ", "));
  }
  return tests::read_text(text + measurements);
}

std::string widening(const std::string& name, const std::string& place) {
  return fmt::format(
      "[[measurement]]\nname = \"{}\"\nkind = \"point_displacement\"\npoint = [{}]\naxis = "
      "\"x\"\n",
      name, place);
}

// The total Lagrangian method gives 0.01379 and 0.00608 m with 12 spacings across; with six, the
// half ring used to move 14 and 20 % too far.
TEST(held_bodies, a_half_ring_on_a_floor_is_widened_as_in_the_total_lagrangian_method) {
  const Case settings = tests::read_text(R"toml(dimension = 2
discretisation = { spacing = "1/12", damping = "adaptive" }
time.end = 3
[[body]]
name = "ring"
material = { model = "linear", youngs_modulus = 1000, poissons_ratio = 0.3, density = 1 }
geometry = { shape = "intersection", of = [
  { shape = "difference", of = [{ shape = "disc", centre = [0, 0], radius = 1 },
                                { shape = "disc", centre = [0, 0], radius = 0.5 }] },
  { shape = "box", lower = [-9, 0], upper = [9, 9] }] }
[[boundary]]
name = "floor"
kind = "fixed"
geometry = { shape = "half_space", point = [0, 0], normal = [0, 1] }
[[boundary]]
name = "inner"
kind = "pressure"
pressure = "20*min(t, 1)"
geometry = { shape = "disc", centre = [0, 0], radius = 0.625 }
[[measurement]]
name = "up"
kind = "point_displacement"
point = [0.53033, 0.53033]
axis = "y"
[[measurement]]
name = "out"
kind = "point_displacement"
point = [0.53033, 0.53033]
)toml");
  Solver solver(settings, {2, kernels::widest_supported()});
  const std::vector<double> found = values_at(solver, 3);
  EXPECT_NEAR(found[0], 0.01379, 0.03 * 0.01379);
  EXPECT_NEAR(found[1], 0.00608, 0.05 * 0.00608);
}

// Beside the planes the quarter used to move too little by 13 %.
TEST(held_bodies, a_quarter_of_a_ring_widens_as_the_ring) {
  const std::string places = widening("inside", "0.53125, 0") + widening("outside", "0.96875, 0") +
                             widening("between", "0.53033, 0.53033");
  std::array<std::vector<double>, 2> found;
  for (const bool part : {false, true}) {
    const Case settings = hollow_body(2, "min(t/2, 1)", 4, part, places);
    EXPECT_TRUE(warnings_of_method(settings).empty());
    remeshed::Solver<double, 2> solver(settings, {2, kernels::widest_supported()});
    found[part] = values_at(solver, 4);
  }
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[1][i] / found[0][i], 1, 0.02) << i;
}

// Lamé's displacement is p a^3/(b^3 - a^3)/E ((1 - 2 nu) r + (1 + nu) b^3/(2 r^2)). At the inner
// surface, where two planes meet, the eighth used to move too little by 30 %. The value half a
// spacing inside the outer surface is the least accurate, in whole balls too.
TEST(held_bodies, an_eighth_of_a_hollow_ball_widens_as_in_closed_form) {
  const Case settings =
      hollow_body(3, "min(t/0.4, 1)", 1.2, true,
                  widening("inside", "0.53125, 0, 0") + widening("outside", "0.96875, 0, 0") +
                      widening("between", "0.433013, 0.433013, 0.433013"));
  remeshed::Solver<double, 3> solver(settings, {2, kernels::widest_supported()});
  const std::vector<double> found = values_at(solver, 1.2);
  const auto exact = [](double r) { return (0.4 * r + 1.3 / (2 * r * r)) / 7000; };
  EXPECT_NEAR(found[0] / exact(0.53125), 1, 0.03);
  EXPECT_NEAR(found[1] / exact(0.96875), 1, 0.05);
  EXPECT_NEAR(found[2] * std::sqrt(3) / exact(0.75), 1, 0.02);
}

}  // namespace
}  // namespace pliant::test

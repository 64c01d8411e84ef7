#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/case/written_case.hpp"
#include "tests/engine/remeshed/small_case.hpp"

// Scaled mass (RP.87) and adaptive damping (RP.88).
namespace pliant::test {
namespace {

constexpr double pi = 3.14159265358979323846;
const kernels::Isa widest = kernels::widest_supported();

/// "[x, y]" or "[x, y, z]".
std::string vector_of(int dimension, const std::string& x, const std::string& y,
                      const std::string& z) {
  return dimension == 2 ? fmt::format("[{}, {}]", x, y) : fmt::format("[{}, {}, {}]", x, y, z);
}

// A viscous block that falls on a wall under gravity. With M times the inertia everything takes
// sqrt(M) times as long if speeds are lower by sqrt(M).
std::string falling_block(int dimension, double slower) {
  const auto vector = [dimension](const char* x, const char* y, const char* z) {
    return vector_of(dimension, x, y, z);
  };
  return fmt::format(
      R"toml(dimension = {}
gravity = {}
[discretisation]
spacing = 0.05
damping = {}
[time]
end = 100
[[body]]
name = "block"
geometry = {{ shape = "box", lower = {}, upper = {} }}
velocity = {}
[body.material]
model = "reduced_polynomial"
density = 1
coefficients = [19.2]
compressibility = 0.024
prony = {{ ratios = [0.3], times = [{}] }}
[[boundary]]
name = "floor"
kind = "contact_wall"
friction = "no_slip"
geometry = {{ shape = "half_space", point = {}, normal = {} }}
[[measurement]]
name = "reaction"
kind = "wall_force"
boundary = "floor"
axis = "y"
[[measurement]]
name = "centre"
kind = "centre_of_mass"
axis = "y"
[[measurement]]
name = "density"
kind = "mean_value"
field = "density"
[[measurement]]
name = "kinetic"
kind = "kinetic_energy"
[[measurement]]
name = "momentum"
kind = "momentum"
axis = "x"
[[measurement]]
name = "mass"
kind = "mass"
)toml",
      dimension, vector("0", "-40", "0"), 8 / slower, vector("-0.1", "0.01", "-0.1"),
      vector("0.1", "0.21", "0.1"),
      vector_of(dimension, fmt::to_string(0.5 / slower), fmt::to_string(-2 / slower), "0"),
      0.02 * slower, vector("0", "0", "0"), vector("0", "1", "0"));
}

template <int D>
void expect_the_same_motion_on_a_slower_clock(int steps) {
  constexpr double scaling = 16, slower = 4;
  remeshed::Solver<double, D> fast(tests::read_text(falling_block(D, 1)), {1, widest});
  remeshed::Solver<double, D> slow(
      tests::read_text(falling_block(D, slower),
                       {fmt::format("remeshed.mass_scaling={}", scaling)}),
      {1, widest});
  for (int k = 0; k < steps; ++k) {
    fast.step(HUGE_VAL);
    slow.step(HUGE_VAL);
  }
  ASSERT_GT(fast.remeshings(), 0);
  EXPECT_EQ(slow.remeshings(), fast.remeshings());
  EXPECT_NEAR(slow.clock().time / fast.clock().time, slower, 1e-12);
  const std::vector<double> a = fast.measure(), b = slow.measure();
  EXPECT_GT(std::abs(a[0]), 0);
  const double factor[] = {slower, 1, 1, 1, scaling / slower, 1};  // the first is an impulse
  for (std::size_t m = 0; m < a.size(); ++m) {
    EXPECT_NEAR(b[m], factor[m] * a[m], 1e-9 * std::abs(b[m])) << m;
  }
  const EnergyBudget of_fast = *fast.energy_budget(), of_slow = *slow.energy_budget();
  EXPECT_NEAR(of_slow.work(), of_fast.work(), 1e-9 * std::abs(of_fast.work()));
  EXPECT_NEAR(of_slow.damping, of_fast.damping, 1e-9 * of_fast.damping);
}

TEST(mass_scaling, moves_bodies_alike_on_a_slower_clock) {
  expect_the_same_motion_on_a_slower_clock<2>(60);
}

TEST(mass_scaling, moves_bodies_in_3d_alike_on_a_slower_clock) {
  expect_the_same_motion_on_a_slower_clock<3>(30);
}

const std::string wave = R"toml(dimension = 2
[discretisation]
spacing = "1/32"
[time]
end = 100
[periodic]
axes = ["x", "y"]
lower = [0, 0]
upper = [1, 1]
[[body]]
name = "medium"
geometry = { shape = "box", lower = [0, 0], upper = [1, 1] }
material = { model = "linear", youngs_modulus = 100, poissons_ratio = 0.3, density = 1 }
velocity = ["1e-4*sin(2*pi*x)", 0]
)toml";
// K + 4/3 mu = 134.6 Pa.
const double frequency = 2 * pi * std::sqrt(100 * 0.7 / (1.3 * 0.4));  // [1/s]

TEST(mass_scaling, slows_waves_by_its_root) {
  Solver solver(tests::read_text(wave, {"remeshed.mass_scaling=25"}), {1, widest});
  const double start = solver.integrals().kinetic_energy;
  for (const double phase : {0.25, 0.5, 1.}) {
    advance_until(solver, phase * pi / (frequency / 5));
    EXPECT_NEAR(solver.integrals().kinetic_energy / start, std::pow(std::cos(phase * pi), 2), 0.01);
  }
}

TEST(adaptive_damping, is_critical_for_a_standing_wave) {
  for (const double scaling : {1., 25.}) {
    Solver solver(tests::read_text(wave, {fmt::format("remeshed.mass_scaling={}", scaling),
                                          "discretisation.damping=adaptive"}),
                  {1, widest});
    EXPECT_EQ(solver.clock().damping, 0);
    solver.step(HUGE_VAL);
    EXPECT_NEAR(solver.clock().damping * std::sqrt(scaling) / (2 * frequency), 1, 0.01) << scaling;
  }
}

// A bar on a symmetry plane whose end is pulled with a growing traction.
std::string bar(int dimension, const std::string& load) {
  const auto vector = [dimension](const char* x, const char* y, const char* z) {
    return vector_of(dimension, x, y, z);
  };
  return fmt::format(
      R"toml(dimension = {}
[discretisation]
spacing = {}
[time]
end = 100
[[body]]
name = "bar"
geometry = {{ shape = "box", lower = {}, upper = {} }}
material = {{ model = "linear", youngs_modulus = 100, poissons_ratio = 0.3, density = 1 }}
[[boundary]]
name = "symmetry"
kind = "slip_wall"
geometry = {{ shape = "half_space", point = {}, normal = {} }}
[[boundary]]
name = "load"
kind = "traction"
traction = {}
geometry = {{ shape = "box", lower = {}, upper = {} }}
[[measurement]]
name = "elongation"
kind = "point_displacement"
point = {}
axis = "x"
)toml",
      dimension, dimension == 2 ? 0.02 : 0.05, vector("0", "-0.1", "-0.1"),
      vector("0.6", "0.1", "0.1"), vector("0", "0", "0"), vector("1", "0", "0"),
      vector_of(dimension, fmt::format("\"{}\"", load), "0", "0"), vector("0.599", "-9", "-9"),
      vector("9", "9", "9"), vector("0.5", "0", "0"));
}

struct Pulled {
  double elongation, created;  ///< [m]; energy created over the work
};

template <int D>
Pulled pulled(const std::string& load, const Settings& settings) {
  remeshed::Solver<double, D> solver(tests::read_text(bar(D, load), settings), {1, widest});
  advance_until(solver, 9);
  const BodyIntegrals sum = solver.integrals();
  const EnergyBudget budget = *solver.energy_budget();
  const double created = sum.kinetic_energy + sum.strain_energy - budget.work() + budget.damping;
  return {solver.measure()[0], created / budget.work()};
}

// The load grows during 20 crossings of the scaled bar by a wave.
template <int D>
void expect_the_same_elongation(double exact, double elongation_bound, double energy_bound) {
  const std::string load = "2*min(t/6, 1)";
  const Pulled mass = pulled<D>(load, {"discretisation.damping=3"});
  const Pulled scaled = pulled<D>(load, {"discretisation.damping=3", "remeshed.mass_scaling=25"});
  EXPECT_NEAR(scaled.elongation / mass.elongation, 1, elongation_bound);
  EXPECT_NEAR(scaled.elongation, exact, 6 * elongation_bound * exact);
  EXPECT_NEAR(mass.created, 0, energy_bound);
  EXPECT_NEAR(scaled.created, 0, energy_bound);
}

// Plane strain stiffens by 1/(1 - nu^2).
TEST(mass_scaling, leaves_the_elongation_of_a_bar_as_it_is) {
  expect_the_same_elongation<2>(0.5 * 2 / 100 * 0.91, 0.005, 0.03);
}

// Four particles across. Edges of loads are coarse in 3D, with any mass: 0.05 is the tolerance of
// `checks.energy`.
TEST(mass_scaling, leaves_the_elongation_of_a_bar_in_3d_as_it_is) {
  expect_the_same_elongation<3>(0.5 * 2 / 100, 0.01, 0.05);
}

// A wave crosses the bar in 0.3 s. Without damping the end would swing between 0 and twice the
// elongation.
TEST(adaptive_damping, brings_a_bar_under_a_sudden_load_to_rest) {
  const Settings scaled = {"remeshed.mass_scaling=25", "discretisation.damping=adaptive"};
  const Pulled at_rest = pulled<2>("2", scaled);
  EXPECT_NEAR(at_rest.elongation, 0.5 * 2 / 100 * 0.91, 0.03 * 0.0091);
  EXPECT_NEAR(at_rest.created, 0, 0.03);
}

}  // namespace
}  // namespace pliant::test

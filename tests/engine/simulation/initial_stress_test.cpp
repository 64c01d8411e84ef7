#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/simulation/methods.hpp"
#include "engine/simulation/watch.hpp"
#include "tests/engine/case/written_case.hpp"

namespace pliant::test {
namespace {

/// A bar along x, 10 x 2 (x 2), fixed at x = 0; its weight requires sigma_xx = rho g (10 - x).
Case hanging_bar(const std::string& method, int dimension, const std::string& stress) {
  const bool is_solid = dimension == 3, has_mesh = method == "finite_elements";
  const std::string box =
      is_solid ? "lower = [0, -1, -1], upper = [10, 1, 1]" : "lower = [0, -1], upper = [10, 1]";
  const std::string mesh = PLIANT_SOURCE_DIR "/cases/cantilever/beam.msh";
  const std::string shape =
      has_mesh ? "shape = \"mesh\", file = \"" + mesh + "\"" : "shape = \"box\", " + box;
  const std::string zero = is_solid ? ", 0, 0]" : ", 0]";
  return tests::read_text(
      "dimension = " + std::to_string(dimension) + "\nmethod = \"" + method + "\"\ngravity = [0.1" +
      zero + "\n[discretisation]\nspacing = 0.5\n[time]\nend = 2\n" +
      (method == "total_lagrangian" ? "[total_lagrangian]\ndamping = 0\n" : "") +
      "[[body]]\nname = \"bar\"\ngeometry = { " + shape + " }\nmaterial = { model = \"" +
      (method == "point_based" || has_mesh ? "neo_hookean" : "linear") +
      "\", youngs_modulus = 1e5, poissons_ratio = 0.3, density = 1000 }\n" + stress +
      "[[boundary]]\nname = \"ceiling\"\nkind = \"fixed\"\ngeometry = { shape = "
      "\"half_space\", point = [0" +
      zero + ", normal = [1" + zero +
      " }\n"
      "[[measurement]]\nname = \"end\"\nkind = \"point_displacement\"\naxis = \"x\"\npoint = [9.5, "
      "0.25" +
      (is_solid ? ", 0.25]\n" : "]\n"));
}

struct Weights : testing::TestWithParam<std::pair<const char*, int>> {};

// The free bar swings by rho g L^2/E = 0.1 m, with a period of 4 s.
TEST_P(Weights, are_borne_by_a_stress_that_balances_them) {
  const auto [method, dimension] = GetParam();
  double moved[2], energy[2];
  for (const bool is_stressed : {false, true}) {
    const Case settings =
        hanging_bar(method, dimension, is_stressed ? "stress = { xx = \"100*(10 - x)\" }\n" : "");
    const auto solver = methods().make(settings, {});
    Watch watch(settings);
    watch.begin(*solver);
    solver->advance(2);
    moved[is_stressed] = solver->measure()[0];
    energy[is_stressed] = solver->integrals().kinetic_energy;
    EXPECT_EQ(watch.observe(*solver, true), "");
  }
  EXPECT_NEAR(moved[0], 0.1, 0.025);
  EXPECT_LT(std::abs(moved[1]), 0.03 * moved[0]);
  EXPECT_LT(energy[1], 0.1) << "of 50 J that gravity can give";
}

INSTANTIATE_TEST_SUITE_P(methods, Weights,
                         testing::Values(std::pair("remeshed", 2), std::pair("total_lagrangian", 2),
                                         std::pair("total_lagrangian", 3),
                                         std::pair("point_based", 2), std::pair("point_based", 3),
                                         std::pair("finite_elements", 3)),
                         [](const auto& sample) {
                           return std::string(sample.param.first) + "_" +
                                  std::to_string(sample.param.second);
                         });

// The ends of a taut bar spring back a little at the start, which gives them more kinetic energy
// than the vibration has. That energy was in the stress.
TEST(initial_stress, does_not_create_the_energy_with_which_ends_spring_back) {
  Case settings = tests::read_text(R"toml(method = "point_based"
dimension = 3
discretisation = { spacing = 0.05 }
time = { end = 15 }
[[body]]
name = "bar"
geometry = { shape = "box", lower = [0, -0.1, -0.1], upper = [1, 0.1, 0.1] }
velocity = [0, 0, "1e-5*cos(pi*x)"]
stress = { xx = 0.05 }
material = { model = "neo_hookean", youngs_modulus = 1, poissons_ratio = 0.3, density = 1 }
[[boundary]]
name = "left"
kind = "slip_wall"
geometry = { shape = "half_space", point = [0, 0, 0], normal = [1, 0, 0] }
[[boundary]]
name = "right"
kind = "slip_wall"
geometry = { shape = "half_space", point = [1, 0, 0], normal = [-1, 0, 0] }
)toml");
  const auto solver = methods().make(settings, {});
  Watch watch(settings);
  watch.begin(*solver);
  double largest = 0;
  for (int k = 1; k <= 5; ++k) {
    solver->advance(3 * k);
    EXPECT_EQ(watch.observe(*solver, true), "");
    largest = std::max(largest, solver->integrals().kinetic_energy);
  }
  EXPECT_GT(largest, 100 * 0.5 * 0.04 * 1e-10 / 2) << "of the vibration";
}

/// Two layers of 10 x 0.5, tied; the lower one is compressed along them.
Case bimetal_strip(const std::string& method, double upper_modulus) {
  const auto layer = [&](const char* name, const char* lower, const char* upper, double modulus) {
    return fmt::format(
        "[[body]]\nname = \"{}\"\ngeometry = {{ shape = \"box\", lower = [-5, {}], upper = [5, {}] "
        "}}\nmaterial = {{ model = \"linear\", youngs_modulus = {}, poissons_ratio = 0.3, density "
        "= 1 "
        "}}\n",
        name, lower, upper, modulus);
  };
  const auto height = [](const char* name, double x) {
    return fmt::format(
        "[[measurement]]\nname = \"{}\"\nkind = \"point_displacement\"\nbody = \"lower\"\n"
        "point = [{}, -0.01]\naxis = \"y\"\n",
        name, x);
  };
  return tests::read_text("method = \"" + method + "\"\n[" + method +
                          "]\ndamping = \"adaptive\"\n[discretisation]\nspacing = \"1/6\"\n[time]\n"
                          "end = 8\n" +
                          layer("lower", "-0.5", "0", 1000) + "stress = { xx = -2.1978 }\n" +
                          layer("upper", "0", "0.5", upper_modulus) +
                          "[[contact]]\nbodies = [\"lower\", \"upper\"]\nkind = \"tied\"\n" +
                          height("end", 4.9) + height("middle", 0));
}

// A strain of 0.002 that the other layer hinders: the curvature of Timoshenko (1925), in plane
// strain. What the stress gives up is an energy of the run: compared with the motion alone, which
// damping keeps slow, the energy that the first impact creates at the bond would end these runs.
TEST(initial_stress, of_one_layer_bends_a_bimetal_strip) {
  for (const char* method : {"total_lagrangian", "point_based"}) {
    for (const double ratio : {1., 2., 10.}) {
      SCOPED_TRACE(fmt::format("{}, ratio of the moduli {}", method, ratio));
      const Case settings = bimetal_strip(method, 1000 * ratio);
      const auto solver = methods().make(settings, {});
      Watch watch(settings);
      watch.begin(*solver);
      std::string warnings;
      while (solver->clock().time < settings.time.end) {
        solver->step(settings.time.end - solver->clock().time);
        warnings += watch.observe(*solver, false);
      }
      EXPECT_EQ(warnings, "");
      const double curvature = 24 * 0.002 / (12 + (1 + 1 / ratio) * (1 + ratio));
      const std::vector<double> height = solver->measure();
      const double sagitta = curvature * 4.9 * 4.9 / 2;
      EXPECT_NEAR(height[0] - height[1], sagitta, 0.015 * sagitta);
    }
  }
}

// A stiff string with clamped ends vibrates at sqrt(sigma/rho)/(2 L) (1 + 2 e + (4 + pi^2/2) e^2),
// with e = H/L sqrt(E/((1 - nu^2) 12 sigma)) (Fletcher & Rossing 1998, 2.18.1). Without tension the
// period of the bar is three times as long.
TEST(initial_stress, of_tension_makes_a_bar_a_string) {
  for (const std::string method : {"total_lagrangian", "point_based"}) {
    const Case settings = tests::read_text(
        "method = \"" + method + "\"\n[discretisation]\nspacing = 0.0125\n[time]\nend = 1\n" +
        (method == "total_lagrangian" ? "[total_lagrangian]\ndamping = 0\n" : "") +
        R"toml([[body]]
name = "bar"
geometry = { shape = "box", lower = [0, -0.025], upper = [1, 0.025] }
velocity = [0, "0.01*sin(pi*x)"]
stress = { xx = 10 }
material = { model = ")toml" +
        (method == "point_based" ? "neo_hookean" : "linear") +
        R"toml(", youngs_modulus = 100, poissons_ratio = 0.3, density = 1 }
[[boundary]]
name = "left"
kind = "fixed"
geometry = { shape = "half_space", point = [0, 0], normal = [1, 0] }
[[boundary]]
name = "right"
kind = "fixed"
geometry = { shape = "half_space", point = [1, 0], normal = [-1, 0] }
[[measurement]]
name = "middle"
kind = "point_displacement"
point = [0.5, 0]
axis = "y"
)toml");
    const auto solver = methods().make(settings, {});
    const double start = solver->integrals().kinetic_energy;
    double before = 0, crossing = 0;
    while (crossing == 0 && solver->clock().time < 1) {
      const double time = solver->clock().time;
      solver->step(1);
      const double now = solver->measure(0);
      if (before > 0 && now <= 0) {
        crossing = time + (solver->clock().time - time) * before / (before - now);
      }
      before = now;
    }
    const double e = 0.05 * std::sqrt(100 / 0.91 / (12 * 10));
    const double frequency = std::sqrt(10.) / 2 * (1 + 2 * e + (4 + M_PI * M_PI / 2) * e * e);
    EXPECT_NEAR(1 / (2 * crossing), frequency, 0.02 * frequency) << method;
    const BodyIntegrals end = solver->integrals();
    EXPECT_NEAR(end.kinetic_energy + end.strain_energy, start, 0.02 * start) << method;
  }
}

}  // namespace
}  // namespace pliant::test

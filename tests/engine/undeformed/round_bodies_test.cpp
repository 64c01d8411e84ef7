#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "engine/simulation/methods.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/undeformed/loads.hpp"

// Contact of discs and spheres, (TL.15) and (TL.16), compared with other solutions.
namespace pliant::test {
namespace {

// Neo-Hookean here; finite elements with a linear material give 0.9717, see cases/two_discs.
TEST(bodies_in_contact, leave_an_impact_with_the_restitution_of_finite_elements) {
  for (const std::string method : {"total_lagrangian", "point_based"}) {
    std::string discs = "method = \"" + method + R"("
dimension = 2
discretisation = { spacing = 0.035 }
time = { end = 0.6 }
[material.rubber]
model = "reduced_polynomial"
density = 1
coefficients = [19.2307692307692]
compressibility = 0.024
[[contact]]
bodies = ["left", "right"]
)";
    for (const std::string name : {"left", "right"}) {
      const std::string sign = name == "left" ? "-" : "", other = name == "left" ? "" : "-";
      discs += "[[body]]\nname = \"" + name +
               "\"\nmaterial = \"rubber\"\ngeometry = { shape = \"disc\", centre = [" + sign +
               "0.525, 0], radius = 0.5 }\nvelocity = [" + other + "0.5, 0]\n" +
               measurement(name, "kind = \"momentum\"\naxis = \"x\"\nbody = \"" + name +
                                     "\"\nrelative = true\n");
    }
    const auto run = methods().make(tests::read_text(discs), {});
    const BodyIntegrals before = run->integrals();
    const double momentum = values(*run)["left"];
    run->advance(0.6);
    EXPECT_NEAR(values(*run)["left"] / momentum, -0.9717, 0.003) << method;
    const BodyIntegrals after = run->integrals();
    EXPECT_NEAR(after.momentum[0], 0, 1e-14);
    EXPECT_NEAR(after.kinetic_energy + after.strain_energy, before.kinetic_energy,
                0.01 * before.kinetic_energy);
  }
}

/// Approach of the middles of two equal spheres of radius R under this force: by Hertz, minus the
/// effect of the other end of each sphere, which is pressed in the same way (Tatara 1989).
double approach_of_spheres(double force, double radius) {
  constexpr double young = 100, nu = 0.3, pi = 3.14159265358979;
  const double a = std::cbrt(3 * force * (radius / 2) * (1 - nu * nu) / (2 * young));
  const double across = std::hypot(a, 2 * radius);
  return 2 * (3 * (1 - nu * nu) * force / (4 * a * young) -
              force / (pi * young) *
                  (2 * (1 + nu) * radius * radius / std::pow(across, 3) + (1 - nu * nu) / across));
}

// A quarter of two half spheres between planes of symmetry; the radius of contact is five spacings.
TEST(bodies_in_contact, push_as_the_spheres_of_hertz) {
  const auto half = [](const std::string& name, const std::string& centre, const std::string& lower,
                       const std::string& upper) {
    return "[[body]]\nname = \"" + name +
           "\"\nmaterial = \"rubber\"\ngeometry = { shape = \"intersection\", of = [{ shape = "
           "\"ball\", centre = [" +
           centre + ", 0, 0], radius = 0.5 }, { shape = \"box\", lower = [" + lower +
           ", 0, 0], upper = [" + upper + ", 1, 1] }] }\n";
  };
  const std::string spheres = R"(method = "total_lagrangian"
dimension = 3
discretisation = { spacing = 0.02 }
time = { end = 0.6 }
[total_lagrangian]
damping = 8
[material.rubber]
model = "reduced_polynomial"
density = 1
coefficients = [19.2307692307692]
compressibility = 0.024
[[contact]]
bodies = ["left", "right"]
)" + half("left", "-0.5", "-0.5", "1") +
                              half("right", "0.5", "-1", "0.5") +
                              half_space("x", "kind = \"slip_wall\"", "[-0.5, 0, 0]", "[1, 0, 0]") +
                              half_space("y", "kind = \"slip_wall\"", "[0, 0, 0]", "[0, 1, 0]") +
                              half_space("z", "kind = \"slip_wall\"", "[0, 0, 0]", "[0, 0, 1]") +
                              half_space("press",
                                         "kind = \"slip_wall\"\ndisplacement = "
                                         "[\"-0.04*min(t/0.36, 1)\", 0, 0]",
                                         "[0.5, 0, 0]", "[-1, 0, 0]") +
                              measurement("force",
                                          "kind = \"contact_force\"\nbodies = [\"right\", "
                                          "\"left\"]\naxis = \"x\"\n");
  const auto run = methods().make(tests::read_text(spheres), {});
  run->advance(0.5);
  const double before = values(*run)["force"];
  run->advance(0.6);
  const double force = 4 * (values(*run)["force"] - before) / 0.1;
  EXPECT_NEAR(approach_of_spheres(force, 0.5), 0.04, 0.05 * 0.04);
}

// The largest force, its time and the end of contact, by make_reference.py in the folder of the
// case; waves in the spheres keep 1/500 of the momentum.
TEST(bodies_in_contact, collide_as_the_spheres_of_hertz) {
  for (const std::string method : {"total_lagrangian", "point_based"}) {
    const auto run = methods().make(read_case(PLIANT_SOURCE_DIR "/cases/two_spheres",
                                              std::vector<std::string>{"method=" + method}),
                                    {});
    const double momentum = values(*run)["momentum_of_left"];
    double largest = 0, at = 0, end = 0, before = 0;
    for (int sample = 1; sample <= 80; ++sample) {
      run->advance(0.01 * sample);
      const double impulse = values(*run)["force"], force = (impulse - before) / 0.01;
      before = impulse;
      if (force > largest) largest = force, at = 0.01 * sample - 0.005;
      if (force > 0.02 * largest) end = 0.01 * sample;
    }
    EXPECT_NEAR(largest, 0.0830, 0.04 * 0.0830) << method;
    EXPECT_NEAR(at, 0.294, 0.02) << method;
    EXPECT_NEAR(end, 0.59, 0.03) << method;
    EXPECT_NEAR(values(*run)["momentum_of_left"] / momentum, -0.998, 0.003) << method;
  }
}

// A plate presses a disc by a tenth of its diameter against another one; the force is that with 48
// spacings across, docs/decisions/0082.
TEST(bodies_between_plates, are_warned_of_where_a_disc_has_too_few_spacings) {
  constexpr double right = 418.6;  // [N/m]
  for (const std::string method : {"total_lagrangian", "point_based"}) {
    const auto text = [&](double across) {
      return "method = \"" + method +
             "\"\ndimension = 2\ndiscretisation.spacing = " + fmt::format("{}", 0.1 / across) +
             "\ntime.end = 0.6\n[" + method +
             R"(]
damping = 20
[[body]]
name = "disc"
material = { model = "neo_hookean", density = 1000, youngs_modulus = 1e5, poissons_ratio = 0.3 }
geometry = { shape = "disc", centre = [0, 0], radius = 0.05 }
)" +
             half_space("floor", "kind = \"contact_wall\"\nfriction = \"no_slip\"", "[0, -0.05]",
                        "[0, 1]") +
             half_space("plate",
                        "kind = \"contact_wall\"\nfriction = \"no_slip\"\ndisplacement = [0, "
                        "\"-0.01*(1 - cos(pi*min(t/0.3, 1)))/2\"]",
                        "[0, 0.05]", "[0, -1]") +
             measurement("force", "kind = \"wall_force\"\nboundary = \"floor\"\naxis = \"y\"\n");
    };
    const auto force = [&](double across) {
      const auto run = methods().make(tests::read_text(text(across)), {});
      run->advance(0.5);
      const double before = values(*run)["force"];
      run->advance(0.6);
      return (values(*run)["force"] - before) / 0.1;
    };
    EXPECT_EQ(warnings_of_method(tests::read_text(text(7))).size(), 1U) << method;
    EXPECT_NEAR(force(7), 0.92 * right, 0.015 * right) << method;
    EXPECT_TRUE(warnings_of_method(tests::read_text(text(14))).empty()) << method;
    EXPECT_NEAR(force(14), right, 0.02 * right) << method;
  }
}

// The body meets an approaching frictionless wall after half a turn or a whole turn. Its surface
// has turned with it, so that it leaves with twice the velocity of the wall, more or less as its
// corners pass.
TEST(bodies_that_turn, meet_walls_with_the_surface_that_they_have_then) {
  for (const std::string method : {"total_lagrangian", "point_based"}) {
    for (const std::string angular_velocity : {"0", "2*pi", "4*pi"}) {
      const std::string disc = "method = \"" + method + R"("
dimension = 2
discretisation = { spacing = 0.1 }
time = { end = 1 }
[material.rubber]
model = "neo_hookean"
density = 1
youngs_modulus = 20000
poissons_ratio = 0.3
[[body]]
name = "disc"
material = "rubber"
geometry = { shape = "disc", centre = [0.01, 0.02], radius = 0.5 }
rotation = { centre = [0.01, 0.02], angular_velocity = ")" +
                               angular_velocity + R"(" }
[[boundary]]
name = "wall"
kind = "contact_wall"
displacement = [0, "0.2*t"]
geometry = { shape = "half_space", point = [0, -0.58], normal = [0, 1] }
)" + measurement("momentum", "kind = \"momentum\"\naxis = \"y\"") +
                               measurement("mass", "kind = \"mass\"");
      const auto run = methods().make(tests::read_text(disc), {});
      run->advance(0.48);
      EXPECT_NEAR(values(*run)["momentum"], 0, 1e-9) << method << angular_velocity;
      run->advance(1);
      auto measured = values(*run);
      EXPECT_NEAR(measured["momentum"] / measured["mass"], 0.4, 0.15) << method << angular_velocity;
    }
  }
}

}  // namespace
}  // namespace pliant::test

#include <gtest/gtest.h>

#include <cmath>

#include "engine/remeshed/contact/contact_momentum_correction.hpp"
#include "engine/remeshed/observe/integrals.hpp"
#include "engine/remeshed/solver.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/invariants/sample_runs.hpp"

// Bodies in contact: what passes between them, and what does not.
namespace pliant::test {
namespace {

const Settings coarse = {"discretisation.spacing=0.06", "measurement=[]"};
const std::string soft =
    R"(material = { model = "reduced_polynomial", coefficients = [8], compressibility = 0.03, )"
    R"(density = 2 } })";
const std::string hard =
    R"(material = { model = "linear", youngs_modulus = 60, poissons_ratio = 0.4, density = 1 } })";

/// Bodies of different shapes and materials; the first one moves into the others at 1.5 m/s.
const std::string bodies =
    R"(body=[{ name = "disc", geometry = { shape = "disc", centre = [-0.51, 0.1], radius = 0.5 }, )"
    R"(velocity = [1.5, 0.2], )" +
    hard +
    R"(, { name = "box", geometry = { shape = "box", lower = [0, -0.3], upper = [0.7, 0.5] }, )" +
    soft +
    R"(, { name = "last", geometry = { shape = "disc", centre = [1.16, 0.2], radius = 0.45 }, )" +
    hard + "]";

double momentum(Solver& solver, int axis) { return solver.integrals().momentum[axis]; }

double momentum_of(Solver& solver, int body, int axis) {
  return remeshed::budget_momentum<double, 2>(solver.state(), body)[axis];
}

TEST(body_contact, keeps_the_momentum_of_all_bodies_to_rounding) {
  for (const char* kind : {"frictionless", "no_slip", "coulomb"}) {
    const std::string contacts = std::string("contact=[{ bodies = [\"disc\", \"box\"], kind = \"") +
                                 kind + "\"" +
                                 (std::string(kind) == "coulomb" ? ", friction = 0.3" : "") +
                                 " }, { bodies = [\"last\", \"box\"] }]";
    Solver solver(small_case("two_discs", coarse + Settings{bodies, contacts}),
                  {2, kernels::widest_supported()});
    const double x = momentum(solver, 0), y = momentum(solver, 1);
    const double last = momentum_of(solver, 2, 0);
    EXPECT_NEAR(x, 1.5 * 3.14159 / 4, 0.01);
    for (int part = 1; part <= 5; ++part) {
      advance_until(solver, 0.1 * part);
      EXPECT_NEAR(momentum(solver, 0), x, 1e-12 * x) << kind;
      EXPECT_NEAR(momentum(solver, 1), y, 1e-12 * x) << kind;
    }
    EXPECT_EQ(last, 0);
    EXPECT_GT(momentum_of(solver, 2, 0), 0.3 * x) << "the blow has gone through the box";
  }
}

// Contact is internal to the two, so that gravity moves them as if it were absent. Damping acts on
// the velocities within a step, before they are corrected.
TEST(body_contact, leaves_gravity_and_damping_their_momentum) {
  Solver solver(
      small_case("two_discs", coarse + Settings{"gravity=[0.5, -2]", "discretisation.damping=1.5",
                                                "body.left.velocity=[1, 0]"}),
      {2, kernels::widest_supported()});
  const double mass = solver.integrals().mass, x = momentum(solver, 0);
  advance_until(solver, 0.3);
  const double kept = std::exp(-1.5 * 0.3), gained = mass * (1 - kept) / 1.5;
  EXPECT_NEAR(momentum(solver, 0), x * kept + 0.5 * gained, 1e-4 * mass);
  EXPECT_NEAR(momentum(solver, 1), -2 * gained, 1e-4 * mass);
}

// The integral over the body and the momentum budget are independent sums over particles.
TEST(body_contact, has_a_budget_of_what_the_bodies_have) {
  Solver solver(small_case("two_discs", coarse), {2, kernels::widest_supported()});
  for (const double time : {0.1, 0.3, 0.5}) {
    advance_until(solver, time);
    const auto views = solver.on_nodes();
    const auto sum = remeshed::integrate<double, 2>(views[0], solver.state().boundaries, Vector{});
    EXPECT_NEAR(sum.momentum[0], momentum_of(solver, 0, 0), 0.02 * 0.39);
  }
}

TEST(body_contact, of_like_discs_is_the_same_for_both) {
  Solver solver(small_case("two_discs", coarse), {2, kernels::widest_supported()});
  advance_until(solver, 0.6);
  EXPECT_LT(momentum_of(solver, 0, 0), -0.8 * 0.39);
  EXPECT_NEAR(momentum_of(solver, 0, 0), -momentum_of(solver, 1, 0), 1e-13);
}

// The momentum of a free body changes by the force on it, which is that of contact alone.
TEST(body_contact, force_is_what_changes_the_momentum) {
  const auto force = [](const char* first, const char* second) {
    return std::string("measurement=[{ name = \"push\", kind = \"contact_force\", bodies = [\"") +
           first + "\", \"" + second + "\"], axis = \"x\" }]";
  };
  for (const char* kind : {"frictionless", "no_slip", "tied"}) {
    for (const bool is_first : {true, false}) {
      Solver solver(
          small_case("bimaterial_bar",
                     {"discretisation.spacing=0.02", "periodic.upper=[inf, 0.16]",
                      std::string("contact.0.kind=") + kind, "body.left.velocity=[0.1, 0]",
                      is_first ? force("left", "right") : force("right", "left")}),
          {2, kernels::widest_supported()});
      const int body = is_first ? 0 : 1;
      const double before = momentum_of(solver, body, 0);
      EXPECT_EQ(solver.measure()[0], 0);
      advance_until(solver, 0.05);
      EXPECT_EQ(solver.measure()[0] < 0, is_first) << kind;
      EXPECT_NEAR(solver.measure()[0], momentum_of(solver, body, 0) - before, 1e-12) << kind;
    }
  }
}

/// A block on a block on the ground, both with the stress of their weight, so that they start in
/// equilibrium; the upper one moves to the right. mu = 0.2.
Case block_on_block(const std::string& speed) {
  const std::string text = R"toml(
[discretisation]
spacing = 0.05
[time]
end = 1
[[body]]
name = "lower"
geometry = { shape = "box", lower = [0, 0], upper = [2, 0.4] }
stress = { yy = "-10*(0.4 - y) - (abs(x - 0.9) < 0.3 ? 4 : 0)" }
material = { model = "linear", youngs_modulus = 1000, poissons_ratio = 0, density = 1 }
[[body]]
name = "upper"
geometry = { shape = "box", lower = [0.6, 0.4], upper = [1.2, 0.8] }
stress = { yy = "-10*(0.8 - y)" }
velocity = [)toml" + speed +
                           R"toml(, 0]
material = { model = "linear", youngs_modulus = 1000, poissons_ratio = 0, density = 1 }
[[boundary]]
name = "ground"
kind = "fixed"
geometry = { shape = "half_space", point = [0, 0], normal = [0, 1] }
[[contact]]
bodies = ["upper", "lower"]
kind = "coulomb"
friction = 0.2
)toml";
  return tests::read_text("gravity = [0, -10]\n" + text);
}

// v = v0 - mu g t: of 0.4 m/s, 0.2 are left after 0.1 s (0.21 here, 0.200 with half the spacing).
// At 0.3 s the block is at rest except for its vibrations.
TEST(body_contact, slows_a_block_that_slides_by_its_friction) {
  Solver solver(block_on_block("0.4"), {2, kernels::widest_supported()});
  const double mass = 0.24;
  advance_until(solver, 0.1);
  EXPECT_NEAR(momentum_of(solver, 1, 0) / mass, 0.2, 0.03);
  const double lost = mass / 2 * (0.4 * 0.4 - 0.2 * 0.2);
  EXPECT_NEAR(solver.energy_budget()->friction, lost, 0.1 * lost);
  advance_until(solver, 0.3);
  EXPECT_NEAR(momentum_of(solver, 1, 0) / mass, 0, 0.03);
}

// The three laws differ only in the bound on the shear.
TEST(body_contact, with_friction_has_the_other_two_laws_as_limits) {
  const auto speed_of = [](const std::string& law) {
    Solver solver(small_case("two_discs", coarse + Settings{bodies,
                                                            "contact=[{ bodies = [\"disc\", "
                                                            "\"box\"], " +
                                                                law + " }]"}),
                  {2, kernels::widest_supported()});
    advance_until(solver, 0.2);
    return momentum_of(solver, 0, 1);
  };
  const double slides = speed_of("kind = \"frictionless\""), holds = speed_of("kind = \"no_slip\"");
  EXPECT_EQ(speed_of("kind = \"coulomb\", friction = 0"), slides);
  EXPECT_EQ(speed_of("kind = \"coulomb\", friction = 1e6"), holds);
  const double between = speed_of("kind = \"coulomb\", friction = 0.1");
  EXPECT_LT(std::min(slides, holds), between);
  EXPECT_GT(std::max(slides, holds), between);
}

// When bodies are pulled apart, contact ends, but a bond remains.
TEST(body_contact, pulls_only_where_bodies_are_tied) {
  const Settings pulled = {"discretisation.spacing=0.02", "periodic.upper=[inf, 0.16]",
                           "measurement=[]", "body.left.velocity=[-0.1, 0]"};
  for (const char* kind : {"frictionless", "tied"}) {
    Solver solver(
        small_case("bimaterial_bar", pulled + Settings{std::string("contact.0.kind=") + kind}),
        {2, kernels::widest_supported()});
    advance_until(solver, 0.05);
    const double right = momentum_of(solver, 1, 0);
    if (std::string(kind) == "tied") {
      EXPECT_LT(right, -0.1 * 0.016);
    } else {
      EXPECT_EQ(right, 0);
    }
  }
}

// Waves of some thousandths pass an interface between stiffnesses of 1 and 4: mixed material would
// be in between.
TEST(body_contact, does_not_mix_tied_materials) {
  Solver solver(small_case("bimaterial_bar", {"discretisation.spacing=0.02", "remeshing.every=2",
                                              "periodic.upper=[inf, 0.16]", "measurement=[]"}),
                {2, kernels::widest_supported()});
  advance_until(solver, 0.06);
  EXPECT_GT(solver.clock().remeshings, 30);
  for (const Body& body : solver.state().bodies) {
    const double rho0 = body.material.density;
    for_each(body.population, Kind::interior, [&](std::int64_t slot, const Cell<2>&) {
      const double rho =
          body.stage[0].get(Field::mass)[slot] / body.stage[0].get(Field::volume)[slot];
      EXPECT_NEAR(rho / rho0, 1, 0.01);
    });
  }
}

}  // namespace
}  // namespace pliant::test

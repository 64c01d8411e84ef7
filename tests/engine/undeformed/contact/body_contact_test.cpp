#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/case/written_case.hpp"
#include "tests/engine/undeformed/loads.hpp"
#include "tests/engine/undeformed/rubber_bodies.hpp"

// Contact between bodies, (TL.15) and (TL.16), in all methods on the undeformed body.
namespace pliant::test {
namespace {

/// Young's modulus 100 Pa, Poisson's ratio 0.3, waves of 11.6 m/s.
constexpr double plane_modulus = 100 / (1 - 0.3 * 0.3);

struct BodiesInContact : RubberBodies {
  std::string start(double end) const { return start_of(0.125, end); }
  /// As box_of, 0.5 deep in 3D.
  std::string box(const std::string& name, double x, double y, double width, double height,
                  double spacing = 0.125) const {
    return box_of(name, x, y, width, height, 0.5, spacing);
  }
  std::string contact(const std::string& first, const std::string& second,
                      const std::string& kind = "kind = \"frictionless\"") const {
    return "[[contact]]\nbodies = [\"" + first + "\", \"" + second + "\"]\n" + kind + "\n";
  }
  std::string force(const std::string& axis) const {
    return measurement(
        "force_" + axis,
        "kind = \"contact_force\"\nbodies = [\"lower\", \"upper\"]\naxis = \"" + axis + "\"\n");
  }
  std::string stress(const std::string& body, const std::string& point) const {
    return measurement(body, "kind = \"material_value\"\nfield = \"stress_yy\"\nbody = \"" + body +
                                 "\"\npoint = " + point + "\n");
  }
  /// A rotation about (0.25, 0.25).
  std::string spinning() const {
    return std::string("[\"0.5*(0.25 - y)\", \"0.5*(x - 0.25)\"") +
           (dimension == 2 ? "]\n" : ", 0]\n");
  }
  std::unique_ptr<pliant::Solver> solver(const std::string& text,
                                         const std::vector<std::string>& more = {}) const {
    const Case settings = tests::read_text(text, more);
    return methods().make(settings, {});
  }
};

INSTANTIATE_TEST_SUITE_P(methods, BodiesInContact, testing::ValuesIn(undeformed_settings()),
                         [](const auto& setting) { return name_of(setting.param); });

// In a mesh the lower block has half the spacing of the upper one.
TEST_P(BodiesInContact, have_the_stress_of_one_body_when_they_are_pressed_together) {
  const std::string blocks = start(2) + "[" + method + "]\ndamping = 8\n" +
                             box("lower", 0, 0, 1, 0.5, 0.0625) + box("upper", 0, 0.5, 1, 0.5) +
                             half_space("floor", "kind = \"slip_wall\"", list(0, 0), list(0, 1)) +
                             half_space("plate",
                                        "kind = \"slip_wall\"\ndisplacement = " +
                                            tests::with(list(0, 7), "7", "\"-0.005*min(t, 1)\""),
                                        list(0, 1), list(0, -1)) +
                             contact("lower", "upper") + force("y") +
                             stress("lower", list(0.3, 0.4, 0.2)) +
                             stress("upper", list(0.7, 0.6, 0.3));
  const auto run = solver(blocks);
  run->advance(1.5);
  const double before = values(*run)["force_y"];
  run->advance(2);
  auto found = values(*run);
  // In 3D the stress is uniaxial.
  const double expected = -0.005 * (dimension == 2 ? plane_modulus : 100);
  const double area = dimension == 2 ? 1 : 0.5;
  EXPECT_NEAR((found["force_y"] - before) / 0.5, expected * area, -0.02 * expected * area);
  EXPECT_NEAR(found["lower"], expected, -0.03 * expected);
  EXPECT_NEAR(found["upper"], expected, -0.03 * expected);
}

// They meet off centre, one turning, and slide: a fifth of a second later they are apart.
TEST_P(BodiesInContact, keep_momenta_and_most_of_the_energy_of_an_impact) {
  for (const std::string kind : {"kind = \"frictionless\"", "kind = \"no_slip\""}) {
    const std::string colliding =
        tests::with(start(0.4), "0.125", "0.0625") + box("lower", 0, 0, 0.5, 0.5, 0.0625) +
        "velocity = " + spinning() + box("upper", 0.2, 0.52, 0.5, 0.5, 0.0625) +
        "velocity = " + list(0, -0.5) + "\n" + contact("lower", "upper", kind) + force("y");
    const auto run = solver(colliding);
    const BodyIntegrals before = run->integrals();
    run->advance(0.4);
    const BodyIntegrals after = run->integrals();
    EXPECT_LT(values(*run)["force_y"], -0.1 * before.mass * 0.5);
    for (int a = 0; a < 3; ++a) {
      EXPECT_NEAR(after.momentum[a], before.momentum[a], 1e-14);
      EXPECT_NEAR(after.angular_momentum[a], before.angular_momentum[a], 2e-3 * before.mass * 0.5);
    }
    const double energy = before.kinetic_energy + before.strain_energy;
    EXPECT_NEAR(after.kinetic_energy + after.strain_energy, energy, 0.04 * energy) << kind;
  }
}

// Gravity along a slope of 0.3, which grows in half a second; the bodies are stiff.
TEST_P(BodiesInContact, stick_and_slide_on_a_slope_by_the_law_of_coulomb) {
  const double across = 1 / std::hypot(1, 0.3), along = 0.3 * across, ramp = 0.5, end = 2;
  for (const double friction : {0.0, 0.2, 0.4}) {
    const std::string gravity =
        fmt::format("gravity = [\"{}*min(2*t, 1)\", \"{}*min(2*t, 1)\"{}]\n", along, -across,
                    dimension == 2 ? "" : ", 0");
    const std::string slope =
        gravity +
        tests::with(tests::with(start(end), "19.2307692307692", "192.307692307692"), "0.024",
                    "0.0024") +
        box("upper", 0.25, 0.5, 0.5, 0.5) + box("lower", 0, 0, 1.5, 0.5) +
        half_space("ground", "kind = \"fixed\"", list(0, 0), list(0, 1)) +
        contact("upper", "lower", fmt::format("kind = \"coulomb\"\nfriction = {}", friction)) +
        measurement("x", "kind = \"centre_of_mass\"\nbody = \"upper\"\naxis = \"x\"\n");
    const auto run = solver(slope);
    const double from = values(*run)["x"];
    run->advance(end);
    const double fall = std::max(along - friction * across, 0.);
    const double rest = end - ramp;
    const double expected = fall * (ramp * ramp / 6 + ramp / 2 * rest + rest * rest / 2);
    EXPECT_NEAR(values(*run)["x"] - from, expected, 0.002 + 0.01 * expected) << friction;
    EXPECT_NEAR(balance(*run), 0, 0.01 * run->energy_budget()->body_force_work) << friction;
  }
}

// Two blocks on the ground, one on the other; the force between them is the weight of the upper
// one.
TEST_P(BodiesInContact, carry_the_weight_of_a_stack) {
  const std::string stack =
      "gravity = " + list(0, -2) + "\n" + start(3) + "[" + method + "]\ndamping = 6\n" +
      box("lower", 0, 0, 0.5, 0.5) + box("upper", 0.0625, 0.5, 0.375, 0.5, 0.0625) +
      half_space("ground", "kind = \"fixed\"", list(0, 0), list(0, 1)) +
      contact("upper", "lower", "kind = \"coulomb\"\nfriction = 0.3") + force("y");
  const auto run = solver(stack);
  run->advance(2);
  const double before = values(*run)["force_y"];
  run->advance(3);
  const double weight = 2 * 0.375 * 0.5 * (dimension == 2 ? 1 : 0.5);
  EXPECT_NEAR(values(*run)["force_y"] - before, -weight, 0.01 * weight);
  EXPECT_LT(run->integrals().kinetic_energy, 1e-4 * weight);
}

TEST_P(BodiesInContact, end_a_run_in_which_they_overlap_too_far) {
  const std::string colliding = start(0.1) + box("lower", 0, 0, 0.5, 0.5) +
                                box("upper", 0, 0.51, 0.5, 0.5) + "velocity = " + list(0, -80) +
                                "\n" + contact("lower", "upper");
  const auto run = solver(colliding, {"time.step=1.5e-3"});
  try {
    run->advance(0.1);
    ADD_FAILURE() << "they pass through each other";
  } catch (const StepFailure& failure) {
    EXPECT_NE(std::string(failure.what()).find("bodies `lower` and `upper` overlap by"),
              std::string::npos)
        << failure.what();
  }
}

TEST_P(BodiesInContact, give_the_same_bytes_over_threads_and_after_a_restart) {
  for (const std::string precision : {"double", "single"}) {
    const Case settings = tests::read_text(
        start(0.2) + box("lower", 0, 0, 0.5, 0.5) + "velocity = " + spinning() +
            box("upper", 0.2, 0.52, 0.5, 0.5) + "velocity = " + list(0, -0.5) + "\n" +
            contact("lower", "upper", "kind = \"coulomb\"\nfriction = 0.2") + force("y"),
        {"precision=" + precision, "output.every=0.0601"});
    const FileContent one = result_of(settings, folder / precision, 1);
    EXPECT_EQ(result_of(settings, folder / (precision + "2"), 2), one);
    EXPECT_EQ(result_of(settings, folder / precision, 2, true), one);
  }
}

/// A block with a slot from its right side, whose jaws move towards each other.
std::string jaws(const std::string& start, int dimension) {
  const auto point = [dimension](const std::string& x, const std::string& z) {
    return "[" + x + (dimension == 2 ? "]" : ", " + z + "]");
  };
  const auto box = [&](const std::string& lower, const std::string& upper) {
    return "{ shape = \"box\", lower = " + lower + ", upper = " + upper + " }";
  };
  return start + "[[body]]\nname = \"jaws\"\nmaterial = \"rubber\"\n" +
         "geometry = { shape = \"difference\", of = [" +
         box(point("0, 0", "0"), point("2, 1", "0.5")) + ", " +
         box(point("0.5, 0.4375", "-1"), point("3, 0.5625", "1")) +
         "] }\nvelocity = " + point("0, \"3*(0.5 - y)*max(x - 0.5, 0)\"", "0") + "\n";
}

TEST_P(BodiesInContact, meet_themselves) {
  if (method == "finite_elements") GTEST_SKIP() << "needs a mesh with a slot";
  const std::string body = tests::with(jaws(start(0.5), dimension), "0.125", "0.0625");
  const std::string places =
      measurement("above", "kind = \"point_displacement\"\naxis = \"y\"\npoint = " +
                               list(1.9, 0.5625, 0.25) + "\n") +
      measurement("below", "kind = \"point_displacement\"\naxis = \"y\"\npoint = " +
                               list(1.9, 0.4375, 0.25) + "\n");
  const auto apart = solver(body + places), meet = solver(body + places + contact("jaws", "jaws"));
  const BodyIntegrals before = meet->integrals();
  double crossed = 1, least = 1;
  for (double time = 0.05; time < 0.51; time += 0.05) {
    apart->advance(time);
    meet->advance(time);
    auto free = values(*apart), found = values(*meet);
    crossed = std::min(crossed, 0.125 + free["above"] - free["below"]);
    least = std::min(least, 0.125 + found["above"] - found["below"]);
  }
  EXPECT_LT(crossed, -0.05);
  EXPECT_GT(least, -0.002);
  const BodyIntegrals after = meet->integrals();
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(after.momentum[a], before.momentum[a], 1e-13);
}

}  // namespace
}  // namespace pliant::test

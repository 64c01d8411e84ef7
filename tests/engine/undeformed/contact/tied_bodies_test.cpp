#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/engine/case/written_case.hpp"
#include "tests/engine/undeformed/loads.hpp"
#include "tests/engine/undeformed/rubber_bodies.hpp"

// Bodies that are tied, (TL.21), in all methods on the undeformed body.
namespace pliant::test {
namespace {

struct TiedBodies : RubberBodies {
  std::string start(double end) const { return start_of(0.0625, end); }
  /// From (x, 0) to (x + width, 0.25), 0.25 deep in 3D.
  std::string part(const std::string& name, double x, double width, double spacing) const {
    return box_of(name, x, 0, width, 0.25, 0.25, spacing);
  }
  std::string halves(double joint, double spacing) const {
    return part("first", 0, joint, 0.0625) + part("second", joint, 1 - joint, spacing) +
           "[[contact]]\nbodies = [\"first\", \"second\"]\nkind = \"tied\"\n";
  }
};

INSTANTIATE_TEST_SUITE_P(methods, TiedBodies, testing::ValuesIn(undeformed_settings()),
                         [](const auto& setting) { return name_of(setting.param); });

/// How a bar that is clamped at its left end swings under sudden gravity.
struct Swing {
  double tip = 0, period = 0;     ///< largest deflection [m], time from rest to rest [s]
  double before = 0, behind = 0;  ///< stress_xx on both sides of the middle at that deflection [Pa]
};

Swing swing_of(pliant::Solver& bar) {
  Swing swing;
  constexpr double end = 3.2, every = 0.02;
  double last = 0;
  for (double time = every; time < end; time += every) {
    bar.advance(time);
    auto now = values(bar);
    if (-now["tip"] > swing.tip) {
      swing.tip = -now["tip"];
      swing.before = now["before"];
      swing.behind = now["behind"];
    }
    if (swing.tip > 0 && time > 1.5 && swing.period == 0 && -now["tip"] > last) swing.period = time;
    last = -now["tip"];
  }
  return swing;
}

TEST_P(TiedBodies, bend_and_swing_as_one_bar) {
  const std::string depth = dimension == 2 ? "" : ", 0.125";
  const auto bar = [&](const std::string& bodies, const std::string& first,
                       const std::string& second) {
    const auto stress = [&](const std::string& name, const std::string& body, double x) {
      return measurement(name, fmt::format("kind = \"material_value\"\nfield = \"stress_xx\"\n"
                                           "body = \"{}\"\npoint = [{}, 0.21{}]\n",
                                           body, x, depth));
    };
    const std::string text =
        "gravity = " + list(0, -0.2) + "\n" + start(4) + bodies +
        half_space("clamp", "kind = \"fixed\"", list(0, 0), list(1, 0)) +
        measurement("tip",
                    fmt::format("kind = \"point_displacement\"\nbody = \"{}\"\npoint = [0.95, "
                                "0.125{}]\naxis = \"y\"\n",
                                second, depth)) +
        stress("before", first, 0.4) + stress("behind", second, 0.6);
    return swing_of(*methods().make(tests::read_text(text), {}));
  };
  const Swing one = bar(part("bar", 0, 1, 0.0625), "bar", "bar");
  const Swing tied = bar(halves(0.5, 0.0625), "first", "second");
  EXPECT_NEAR(tied.tip, one.tip, 0.02 * one.tip);
  EXPECT_NEAR(tied.period, one.period, 0.02 * one.period);
  EXPECT_NEAR(tied.before, one.before, 0.03 * one.before);
  EXPECT_NEAR(tied.behind, one.behind, 0.03 * one.before);
  if (method == "finite_elements") return;
  // Halves of 7.5 and 8.5 spacings, whose nodes match neither each other nor those of the whole
  // bar.
  const double bound = method == "point_based" ? 0.15 : 0.06;
  const Swing uneven = bar(halves(0.46875, 0.0625), "first", "second");
  EXPECT_NEAR(uneven.tip, one.tip, bound * one.tip);
  EXPECT_NEAR(uneven.period, one.period, bound / 2 * one.period);
}

// A bar that turns and stretches; in a mesh its second half has finer elements.
TEST_P(TiedBodies, keep_momenta_and_energy_of_a_free_bar) {
  const std::string velocity = std::string("velocity = [\"0.3*(0.125 - y) + 0.2*sin(3*x)\", ") +
                               "\"0.3*(x - 0.5)\"" + (dimension == 2 ? "]\n" : ", 0]\n");
  std::string bodies = start(1) + part("first", 0, 0.5, 0.0625) + velocity +
                       part("second", 0.5, 0.5, 0.03125) + velocity +
                       "[[contact]]\nbodies = [\"first\", \"second\"]\nkind = \"tied\"\n";
  const auto run = methods().make(tests::read_text(bodies), {});
  const BodyIntegrals before = run->integrals();
  run->advance(1);
  const BodyIntegrals after = run->integrals();
  for (int a = 0; a < 3; ++a) {
    EXPECT_NEAR(after.momentum[a], before.momentum[a], 1e-14);
    EXPECT_NEAR(after.angular_momentum[a], before.angular_momentum[a], 1e-4 * before.mass);
  }
  const double energy = before.kinetic_energy + before.strain_energy;
  EXPECT_NEAR(after.kinetic_energy + after.strain_energy, energy, 0.03 * energy);
}

}  // namespace
}  // namespace pliant::test

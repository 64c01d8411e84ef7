#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "engine/simulation/methods.hpp"
#include "tests/engine/total_lagrangian/blocks.hpp"
#include "tests/engine/undeformed/loads.hpp"

// Cells that the surface of a body cuts, (TL.36).
namespace pliant::test {
namespace {

// The upper side of the block lies between particles, with 0.4 of the last cells inside.
TEST(cut_cells, have_the_moments_of_their_part_in_the_body) {
  const LagrangianSolver<2> solver(
      tests::read_text(tests::with(free_block(2), "upper = [1, 1]", "upper = [1, 1.05]")),
      {1, kernels::widest_supported()});
  const auto& body = solver.state().bodies[0];
  int cut = 0;
  for (const Block<2>& block : body.layout.blocks()) {
    body.layout.for_each_slot(block, [&](std::int64_t p, const Cell<2>& cell) {
      const double fraction = body.fraction[p];
      if (fraction == 0 || fraction == 1) return;
      ++cut;
      const double side = body.lattice.node(cell)[1] > 0.5 ? -1 : 1;
      const auto moments = body.moments(p);
      EXPECT_NEAR(moments[0b10], side * (1 - fraction), 1e-6);
      EXPECT_NEAR(moments[0b01], 0, 1e-12);
      EXPECT_NEAR(moments[0b11], 0, 1e-12);
    });
  }
  EXPECT_EQ(cut, 16);
}

/// A disc or a ball of radius 0.5 in water, with measurements of the stress at 8 places between its
/// middle and its surface, and on the surface.
std::string immersed(int dimension, int across) {
  std::string text =
      tests::with(block_of_law(dimension, "neo_hookean"),
                  dimension == 2 ? R"({ shape = "box", lower = [0, 0], upper = [1, 1] })"
                                 : R"({ shape = "box", lower = [0, 0, 0], upper = [1, 1, 1] })",
                  dimension == 2 ? R"({ shape = "disc", centre = [0, 0], radius = 0.5 })"
                                 : R"({ shape = "ball", centre = [0, 0, 0], radius = 0.5 })") +
      "[[boundary]]\nname = \"water\"\nkind = \"pressure\"\npressure = \"0.01*min(2*t, "
      "1)\"\ngeometry = { shape = \"ball\", centre = [0, 0, 0], radius = 9 }\n";
  text = tests::with(text, "spacing = 0.125", fmt::format("spacing = {}", 1. / across));
  if (dimension == 2)
    text = tests::with(text, R"("ball", centre = [0, 0, 0])", R"("disc", centre = [0, 0])");
  for (const auto& [place, r] : {std::pair{"inside", 0.25}, std::pair{"surface", 0.5}}) {
    for (int k = 0; k < 8; ++k) {
      const double angle = k * std::numbers::pi / 28, tilt = dimension == 2 ? 0 : 0.5;
      const std::array<double, 3> x = {r * std::cos(angle), r * std::sin(angle) * std::cos(tilt),
                                       r * std::sin(angle) * std::sin(tilt)};
      for (const std::string component : {"xx", "yy", "xy"}) {
        text +=
            measurement(fmt::format("{}_{}_{}", place, component, k),
                        fmt::format("kind = \"material_value\"\nfield = \"stress_{}\"\npoint = "
                                    "[{}]\n",
                                    component, fmt::join(x.begin(), x.begin() + dimension, ", ")));
      }
    }
  }
  return text;
}

struct StressErrors {
  double inside = 0, surface = 0;
};

StressErrors errors_of_immersed(int dimension, int across) {
  const auto solver = methods().make(
      tests::read_text(immersed(dimension, across), {"total_lagrangian.damping=20"}), {});
  solver->advance(1);
  StressErrors errors;
  for (const auto& [name, value] : values(*solver)) {
    const double expected = name.find("_xy_") == std::string::npos ? -0.01 : 0;
    double& largest = name.starts_with("inside") ? errors.inside : errors.surface;
    largest = std::max(largest, std::abs(value - expected) / 0.01);
  }
  return errors;
}

// With F in the middle of these cells, stresses on the surface were up to 0.11 (2D) and 0.14 (3D)
// of the pressure off at any spacing.
TEST(cut_cells, are_as_stressed_under_a_pressure_all_around_as_others) {
  for (const int across : {9, 14, 20}) {
    const StressErrors errors = errors_of_immersed(2, across);
    EXPECT_LT(errors.inside, 0.01) << across;
    EXPECT_LT(errors.surface, 0.02) << across;
  }
  for (const int across : {9, 12}) {
    const StressErrors errors = errors_of_immersed(3, across);
    EXPECT_LT(errors.inside, 0.02) << across;
    EXPECT_LT(errors.surface, 0.05) << across;
  }
}

}  // namespace
}  // namespace pliant::test

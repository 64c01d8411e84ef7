#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/engine/total_lagrangian/blocks.hpp"

// Particles at rims, where walls end on a free surface.
namespace pliant::test {
namespace {

/// The block with a fixed wall of the given shape.
LagrangianSolver<3> block_below(const std::string& wall) {
  return LagrangianSolver<3>(
      tests::read_text(free_block(3) +
                       "[[boundary]]\nname = \"wall\"\nkind = \"fixed\"\ngeometry = " + wall +
                       "\n"),
      {1, kernels::widest_supported()});
}

// The border between held and free particles, seen from above, is the rim to second order: every
// free particle of the surface is inside the hole, and every held one outside it or on its rim.
TEST(fit, a_hole_in_a_collar_is_round) {
  for (const double radius : {0.27, 0.33, 0.36}) {
    const auto solver = block_below(
        R"({ shape = "difference", of = [{ shape = "half_space", point = [0, 0, 1], normal = [0, 0, -1] },
  { shape = "cylinder", centre = [0.5, 0.5, 0], axis = [0, 0, 1], radius = )" +
        std::to_string(radius) + " }] }");
    const auto& body = solver.state().bodies[0];
    std::set<std::int64_t> held;
    for (const auto& of_block : body.held) {
      for (const auto& particle : of_block) held.insert(particle.slot);
    }
    int on_rim = 0;
    for_each_particle<3>(body, [&](std::int64_t p, const Point<3>& x) {
      if (x[2] < 0.99) return;
      const double r = std::hypot(x[0] - 0.5, x[1] - 0.5);
      EXPECT_NEAR(x[2], 1, 1e-12);
      if (held.contains(p)) {
        EXPECT_GT(r, radius - 1e-9);
      } else {
        EXPECT_LT(r, radius);
      }
      on_rim += std::abs(r - radius) < 1e-9;
    });
    // As many as the length of the circle, except those on diagonals.
    EXPECT_GT(on_rim, 2 * 3.14 * radius / 0.125 / 1.5);
  }
}

TEST(fit, a_slanted_edge_is_straight) {
  const auto solver = block_below(
      R"({ shape = "intersection", of = [{ shape = "half_space", point = [0, 0, 1], normal = [0, 0, -1] },
  { shape = "half_space", point = [0.53, 0.5, 1], normal = [0.8, 0.6, 0.5] }] })");
  const auto& body = solver.state().bodies[0];
  int on_rim = 0;
  for (const auto& node : body.fitted_nodes) {
    const Point<3> x = body.place(node.slot, body.layout.cell(node.slot));
    if (x[2] < 0.99) continue;
    ++on_rim;
    EXPECT_NEAR(0.8 * (x[0] - 0.53) + 0.6 * (x[1] - 0.5), 0, 1e-3);
  }
  EXPECT_GE(on_rim, 7);
}

// Where wall and body end together, there is no rim on the surface.
TEST(fit, a_clamp_at_the_end_of_a_body_leaves_its_particles) {
  const auto solver =
      block_below(R"({ shape = "half_space", point = [0, 0, 0], normal = [1, 0, 0] })");
  EXPECT_TRUE(solver.state().bodies[0].fitted_nodes.empty());
}

}  // namespace
}  // namespace pliant::test

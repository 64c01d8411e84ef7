#include <gtest/gtest.h>

#include "tests/engine/point_based/blocks.hpp"
#include "tests/engine/undeformed/stretched_bar.hpp"

// Walls hold a body where they are, whatever the spacing.
namespace pliant::test {
namespace {

double pull_of_points(const std::string& walls, const std::string& spacing) {
  const Case settings = tests::read_text(
      free_points(2) + walls, {"discretisation.spacing=" + spacing, "point_based.damping=8"});
  PointSolver<2> solver(settings, {1, kernels::widest_supported()});
  return pull_of(solver);
}

// 2.167 of neo-Hookean rubber stretched by 2 %: E/(1 - nu^2) times 0.02 is 2.198.
TEST(points_at_walls, stretch_a_bar_alike_at_any_spacing) {
  for (const std::string spacing : {"0.125", "0.11", "0.13", "0.09"}) {
    EXPECT_NEAR(pull_of_points(stretching_walls(true, "0"), spacing), 2.167, 0.005 * 2.167)
        << spacing;
  }
}

// Fixed walls at both ends of a block; the middles of cells are next to them.
TEST(points_at_walls, hold_an_octree_where_they_are) {
  const auto pull = [](const std::string& nodes, const std::string& spacing) {
    const Case settings =
        tests::read_text(free_points(2) + stretching_walls(false, "0"),
                         {"discretisation.spacing=" + spacing, "point_based.nodes=" + nodes,
                          "point_based.coarsest_spacing=" + spacing, "point_based.damping=8"});
    PointSolver<2> solver(settings, {1, kernels::widest_supported()});
    return pull_of(solver);
  };
  const double right = pull("lattice", "0.02");
  EXPECT_NEAR(pull("octree", "0.1"), right, 0.02 * right);
  EXPECT_NEAR(pull("octree", "0.05"), right, 0.01 * right);
}

// A cube of nodes in cells of three sizes hangs from a wall. Its weight stretches it by 10.1 mm and
// moves its centre by a third of rho g L^2/E. With the nearest nodes as neighbours, the stretch was
// 11.3 mm.
TEST(points_at_walls, carry_an_octree_of_cells_of_several_sizes) {
  const std::string end =
      measurement("end", "kind = \"point_displacement\"\npoint = [1, 0.5, 0.5]\naxis = \"x\"") +
      measurement("centre", "kind = \"centre_of_mass\"\naxis = \"x\"");
  const Case settings = tests::read_text(
      "gravity = [\"min(t/0.5, 1)\", 0, 0]\n" + free_points(3) +
          half_space("clamp", "kind = \"fixed\"", "[0, 0, 0]", "[1, 0, 0]") + end,
      {"discretisation.spacing=0.0625", "point_based.nodes=octree", "point_based.damping=10",
       "material.rubber.poissons_ratio=0", "material.rubber.youngs_modulus=50"});
  PointSolver<3> solver(settings, {2, kernels::widest_supported()});
  advance_until(solver, 3);
  EXPECT_NEAR(values(solver)["end"], 0.0101, 0.015 * 0.0101);
  EXPECT_NEAR(values(solver)["centre"] - 0.5, 1 / 150., 0.02 / 150);
}

// A wall ends inside the body: the part inside it is rigid, and does not pull at the rest.
TEST(points_at_walls, hold_what_they_cover) {
  const std::string clamps = stretching_walls(false, "0.3");
  const double right = pull_of_points(clamps, "0.02");
  for (const std::string spacing : {"0.05", "0.06", "0.07"}) {
    EXPECT_NEAR(pull_of_points(clamps, spacing), right, 0.02 * right) << spacing;
  }
}

TEST(points_at_walls, share_the_volume_outside) {
  for (const std::string wall : {"0.25", "0.3", "0.41"}) {
    const Case settings =
        tests::read_text(free_points(3) + half_space("clamp", "kind = \"fixed\"",
                                                     "[" + wall + ", 0, 0]", "[1, 0, 0]"));
    PointSolver<3> solver(settings, {1, kernels::widest_supported()});
    const auto& body = solver.state().bodies[0];
    double elastic = 0, least = 1;
    body.for_each_node([&](std::int64_t slot) {
      elastic += body.volume[slot];
      if (body.volume[slot] > 0) least = std::min(least, body.start[slot][0]);
    });
    EXPECT_NEAR(elastic, 1 - std::stod(wall), 0.125 / 16);
    EXPECT_NEAR(least, std::stod(wall), 1e-12);
  }
}

}  // namespace
}  // namespace pliant::test

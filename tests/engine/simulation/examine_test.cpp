#include "engine/simulation/examine.hpp"

#include <gtest/gtest.h>

#include "tests/engine/finite_elements/meshed_block.hpp"
#include "tests/engine/point_based/blocks.hpp"

namespace pliant::test {
namespace {

TEST(examine, counts_nodes_of_a_lattice_whose_volumes_are_those_of_the_block) {
  const Examined found = *examine(tests::read_text(free_points(3)));
  ASSERT_EQ(found.bodies.size(), 1u);
  EXPECT_EQ(found.bodies[0].nodes, 9 * 9 * 9);
  EXPECT_NEAR(found.bodies[0].volume, 1, 1e-12);
  EXPECT_NEAR(found.bodies[0].volume_error(), 0, 1e-6);
  EXPECT_EQ(found.bodies[0].degenerate, 0);
  // Nodes on a face have half of the neighbours: the moment across it is smaller than along it.
  EXPECT_GT(found.bodies[0].condition, 1.5);
  EXPECT_LT(found.bodies[0].condition, 10);
  // (PB.12): the corners have the highest frequency.
  const double c = std::sqrt(100 * 0.7 / (1.3 * 0.4));
  EXPECT_NEAR(found.time_step * c / 0.125, 1, 0.1);
}

TEST(examine, warns_of_a_step_above_the_stability_limit) {
  Case a_case = tests::read_text(free_points(3));
  EXPECT_EQ(examine(a_case)->stability_warning(), "");
  a_case.time.step = 1.01 * examine(a_case)->stable_step;
  EXPECT_NE(examine(a_case)->stability_warning().find("is above the stability limit of"),
            std::string::npos);
}

// A second block that starts 0.01 m inside the first one, which stands on a floor.
TEST(examine, tells_how_deep_surfaces_that_may_touch_start_in_each_other) {
  const std::string text = free_points(3) + R"toml(
[[body]]
name = "upper"
material = "rubber"
geometry = { shape = "box", lower = [0.25, 0.25, 0.99], upper = [0.75, 0.75, 1.49] }
[[contact]]
bodies = ["block", "upper"]
kind = "frictionless"
[[boundary]]
name = "floor"
kind = "contact_wall"
friction = "frictionless"
geometry = { shape = "half_space", point = [0, 0, 0], normal = [0, 0, 1] }
)toml";
  const Examined found = *examine(tests::read_text(text));
  ASSERT_EQ(found.contacts.size(),
            3u);  // between the bodies, and between each of them and the floor
  const ExaminedContact& bodies = found.contacts[0];
  // The surface of a cube of n cells along each side has 6 n^2 + 2 corners.
  EXPECT_EQ(bodies.corners, (std::vector<std::int64_t>{6 * 8 * 8 + 2, 6 * 4 * 4 + 2}));
  EXPECT_EQ(bodies.facets, (std::vector<std::int64_t>{2 * 6 * 8 * 8, 2 * 6 * 4 * 4}));
  EXPECT_NEAR(bodies.penetration, 0.01, 1e-9);
  EXPECT_NEAR(bodies.deepest[2], 0.995, 0.0051);  // a corner of either body
  EXPECT_NE(bodies.text().find("0.01 m deep in each other at the start"), std::string::npos);
  EXPECT_LT(found.contacts[1].penetration, 1e-9);
  EXPECT_EQ(found.contacts[2].names, (std::vector<std::string>{"upper", "floor"}));
  EXPECT_EQ(found.contacts[2].penetration, 0);
  // Impulses do not need a shorter step; the default has a larger margin below the limit.
  EXPECT_NEAR(found.time_step, 0.6 * found.stable_step, 1e-12);
}

TEST(examine, takes_a_step_that_the_case_gives) {
  const Examined found = *examine(tests::read_text(free_points(2), {"time.step=1e-4"}));
  EXPECT_EQ(found.time_step, 1e-4);
  EXPECT_GT(found.stable_step, 1e-3);
  EXPECT_TRUE(found.contacts.empty());
}

TEST(examine, counts_nodes_of_elements_and_nothing_of_other_methods) {
  const TemporaryFolder folder;
  write(unit_block<3>(3), folder / "block.vtk");
  const Examined found = *examine(tests::read_text(meshed_block(folder / "block.vtk")));
  EXPECT_EQ(found.bodies[0].nodes, 64);
  EXPECT_NEAR(found.bodies[0].volume_error(), 0, 1e-12);
  EXPECT_EQ(found.bodies[0].condition, 0);
  EXPECT_FALSE(examine(tests::read_text(tests::block_case)));
}

}  // namespace
}  // namespace pliant::test

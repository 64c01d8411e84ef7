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
  // Nodes on a face see half of the neighbours: the moment across it is a part of that along it.
  EXPECT_GT(found.bodies[0].condition, 1.5);
  EXPECT_LT(found.bodies[0].condition, 10);
  // (PB.12): the corners swing fastest.
  const double c = std::sqrt(100 * 0.7 / (1.3 * 0.4));
  EXPECT_NEAR(found.time_step * c / 0.125, 1, 0.1);
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

#include <gtest/gtest.h>

#include "tests/engine/total_lagrangian/blocks.hpp"
#include "tests/engine/undeformed/stretched_bar.hpp"

// Walls hold a body where they are, and its volume is right, whatever the spacing.
namespace pliant::test {
namespace {

double pull_of_cells(const std::string& walls, const std::string& spacing) {
  const Case settings = tests::read_text(
      free_block(2) + walls, {"discretisation.spacing=" + spacing, "total_lagrangian.damping=8",
                              "body.block.geometry.lower=[0, -0.1]"});
  LagrangianSolver<2> solver(settings, {1, kernels::widest_supported()});
  return pull_of(solver);
}

// With 0.125 there are nodes on both walls.
TEST(cells_at_walls, stretch_a_bar_alike_at_any_spacing) {
  for (const bool slip : {true, false}) {
    const double right = pull_of_cells(stretching_walls(slip, "0"), "0.05");
    for (const std::string spacing : {"0.055", "0.06", "0.07"}) {
      EXPECT_NEAR(pull_of_cells(stretching_walls(slip, "0"), spacing), right, 0.005 * right)
          << slip << ' ' << spacing;
    }
  }
}

template <int D>
void expect_mass(const std::string& upper, double volume) {
  const Case settings = tests::read_text(
      free_block(D), {"discretisation.spacing=0.11", "body.block.geometry.upper=" + upper});
  LagrangianSolver<D> solver(settings, {1, kernels::widest_supported()});
  EXPECT_NEAR(solver.integrals().mass, volume, 0.002 * volume);
}

// Edges are inside cells.
TEST(cells_at_walls, have_the_mass_of_their_body) {
  expect_mass<2>("[0.93, 1]", 0.93);
  expect_mass<3>("[0.93, 1, 0.89]", 0.93 * 0.89);
}

}  // namespace
}  // namespace pliant::test

#include "engine/simulation/lost_stiffness.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "engine/remeshed/solver.hpp"
#include "tests/engine/case/written_case.hpp"

namespace pliant::test {
namespace {

/// The block of tests, with shear modulus 100/2.6 Pa, under an initial shear stress.
std::string warning_under(const std::string& stress,
                          const std::vector<std::string>& settings = {}) {
  const Case block =
      tests::read_text(tests::block_case + "stress = { xy = " + stress + " }\n", settings);
  const remeshed::Solver<double, 2> solver(block, {1, kernels::Isa::sse2});
  return lost_stiffness_warning(solver);
}

// sigma_1 - sigma_2 = 2 sigma_xy.
TEST(stiffness, of_the_linear_material_is_lost_where_principal_stresses_differ_by_2_mu) {
  EXPECT_EQ(warning_under("38"), "");
  const std::string warning = warning_under("39");
  EXPECT_NE(warning.find("`block`"), warning.npos) << warning;
  EXPECT_NE(warning.find("reduced_polynomial"), warning.npos) << warning;
}

TEST(stiffness, lost_in_a_few_particles_alone_is_not_warned_of) {
  EXPECT_EQ(warning_under("\"x < 0.3 && y < 0.1 ? 60 : 0\""), "");
  EXPECT_NE(warning_under("\"y < 0.2 ? 60 : 0\""), "");
}

}  // namespace
}  // namespace pliant::test

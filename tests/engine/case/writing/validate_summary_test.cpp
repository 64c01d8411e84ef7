#include "engine/case/writing/validate_summary.hpp"

#include <gtest/gtest.h>

#include "tests/engine/case/written_case.hpp"

namespace pliant {
namespace {

// Particles: 1 x 2 over 0.1^2. Wave speed: sqrt((83.33 + 4/3 38.46)/2) = 8.204; step: 0.5
// 0.1/8.204.
TEST(validate_summary, it_says_what_a_case_would_run) {
  const std::string text = tests::block_case + R"([[boundary]]
name = "floor"
kind = "fixed"
geometry = { shape = "half_space", point = [0, 0], normal = [0, 1] }
[[measurement]]
name = "weight"
kind = "mass"
)";
  EXPECT_EQ(
      validate_summary(tests::read_text(text)),
      "block: a block, 2D, spacing 0.1 m\n"
      "  body block: about 200 particles, linear elastic, linear equation of state, waves at "
      "8.204 m/s\n"
      "  boundary floor: fixed\n"
      "  time: 1 s in about 83 steps of 0.0122 s (CFL number 1), remeshed at a strain of 0.18 "
      "or a deformation of 0.2\n"
      "  measurements: weight\n");
}

// The area of a disc from a 1024 x 1024 grid: the estimate is accurate to one particle in a
// thousand.
TEST(validate_summary, particles_of_a_disc_fill_its_area) {
  const std::string text =
      tests::with(tests::block_case, "{ shape = \"box\", lower = [0, 0], upper = [1, 2] }",
                  "{ shape = \"disc\", centre = [0, 0], radius = 1 }");
  EXPECT_NE(validate_summary(tests::read_text(text)).find("about 314 particles"),
            std::string::npos);
}

TEST(validate_summary, counts_steps_with_the_time_step_of_a_setup_and_leaves_particles_to_it) {
  const std::string text = validate_summary(tests::read_text(tests::block_case), 0.25);
  EXPECT_NE(text.find("time: 1 s in about 4 steps of 0.25 s, remeshed"), std::string::npos) << text;
  EXPECT_EQ(text.find("particles"), std::string::npos) << text;
}

}  // namespace
}  // namespace pliant

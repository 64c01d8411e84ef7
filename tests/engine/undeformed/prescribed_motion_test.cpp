#include <gtest/gtest.h>

#include <string>

#include "engine/simulation/methods.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/undeformed/loads.hpp"

// Bodies follow walls in all steps, also in the one in which a motion stops.
namespace pliant::test {
namespace {

std::string block(const std::string& method) {
  return "method = \"" + method + R"("
dimension = 2
discretisation = { spacing = 0.25 }
time = { end = 1 }
[[body]]
name = "block"
geometry = { shape = "box", lower = [0, 0], upper = [1, 1] }
material = { model = "neo_hookean", density = 1, youngs_modulus = 100, poissons_ratio = 0.3 }
)";
}

TEST(prescribed_motion, of_a_wall_that_stops_within_a_step_is_that_of_the_body) {
  for (const std::string method : {"total_lagrangian", "point_based"}) {
    for (const std::string kind : {"slip_wall", "moving_wall"}) {
      const auto run = methods().make(
          tests::read_text(
              block(method) +
              half_space("right",
                         "kind = \"" + kind + "\"\ndisplacement = [\"0.02*min(t/0.037, 1)\", 0]",
                         "[1, 0]", "[-1, 0]") +
              half_space("left", "kind = \"fixed\"", "[0, 0]", "[1, 0]") +
              measurement("right", "kind = \"point_displacement\"\npoint = [1, 0.5]") +
              measurement("left", "kind = \"point_displacement\"\npoint = [0, 0.5]")),
          {});
      for (const double time : {0.2, 1.}) {
        run->advance(time);
        auto measured = values(*run);
        EXPECT_NEAR(measured["right"], 0.02, 1e-12) << method << ", " << kind;
        EXPECT_NEAR(measured["left"], 0, 1e-12) << method << ", " << kind;
      }
    }
  }
}

// The lower right corner slides along the moving wall and is held by the wall at rest.
TEST(prescribed_motion, of_the_last_of_two_walls_is_that_of_their_corner) {
  for (const std::string method : {"total_lagrangian", "point_based"}) {
    const auto run = methods().make(
        tests::read_text(block(method) +
                         half_space("right",
                                    "kind = \"slip_wall\"\ndisplacement = [\"0.02*sin(9*t)\", 0]",
                                    "[1, 0]", "[-1, 0]") +
                         half_space("below", "kind = \"fixed\"", "[0, 0]", "[0, 1]") +
                         measurement("corner", "kind = \"point_displacement\"\npoint = [1, 0]")),
        {});
    run->advance(0.5);
    EXPECT_NEAR(values(*run)["corner"], 0, 1e-12) << method;
  }
}

}  // namespace
}  // namespace pliant::test

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "engine/simulation/methods.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/undeformed/loads.hpp"

namespace pliant::test {
namespace {

// The figure of docs/tutorial.md, which is out of date if this test fails.
TEST(tutorial, its_ball_flies_up_again_with_the_momentum_that_it_states) {
  const auto run = methods().make(read_case(PLIANT_SOURCE_DIR "/docs/tutorial/case.toml"), {});
  const double start = values(*run)["momentum"];
  run->advance(0.06);
  EXPECT_NEAR(values(*run)["momentum"] / start, -0.8723, 0.002);
}

// Ghosts fill a shell around the particles: when the ball is round again, it has as many as before.
// At 1 m/s, a fifth of its wave speed, it is compressed to two thirds of its height.
TEST(tutorial, its_ball_leaves_the_floor_at_twice_its_speed_with_the_ghosts_that_it_had) {
  const std::vector<std::string> faster = {"body.ball.velocity=[0.3, 0, -1]"};
  const auto run =
      methods().make(read_case(PLIANT_SOURCE_DIR "/docs/tutorial/case.toml", faster), {});
  const double start = values(*run)["momentum"];
  const auto ghosts = static_cast<double>(run->ghosts());
  run->advance(0.06);
  EXPECT_NEAR(static_cast<double>(run->ghosts()), ghosts, 0.05 * ghosts);
  const double restitution = -values(*run)["momentum"] / start;
  EXPECT_GT(restitution, 0.7);
  EXPECT_LT(restitution, 1);
}

}  // namespace
}  // namespace pliant::test

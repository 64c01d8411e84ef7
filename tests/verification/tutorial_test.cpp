#include <gtest/gtest.h>

#include "engine/simulation/methods.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/undeformed/loads.hpp"

// The first case that a newcomer runs.
namespace pliant::test {
namespace {

// The figure of docs/tutorial.md: it goes stale where this fails.
TEST(tutorial, its_ball_flies_up_again_with_the_momentum_that_it_states) {
  const auto run = methods().make(read_case(PLIANT_SOURCE_DIR "/docs/tutorial/case.toml"), {});
  const double start = values(*run)["momentum"];
  run->advance(0.06);
  EXPECT_NEAR(values(*run)["momentum"] / start, -0.8747, 0.002);
}

}  // namespace
}  // namespace pliant::test

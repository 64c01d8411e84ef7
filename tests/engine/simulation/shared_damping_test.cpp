#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "engine/simulation/methods.hpp"
#include "tests/engine/case/written_case.hpp"

// The damping of [discretisation] is that of the method, unless its own table has one.
namespace pliant::test {
namespace {

const std::string moving_block = R"toml(dimension = 2
discretisation.spacing = 0.25
time.end = 1
[[body]]
name = "block"
geometry = { shape = "box", lower = [0, 0], upper = [1, 1] }
material = { model = "linear", youngs_modulus = 100, poissons_ratio = 0.3, density = 1 }
velocity = [0, 1]
)toml";

/// Momentum that is left of 1 N s/m after 1 s.
double momentum(const std::string& method, std::vector<std::string> settings) {
  settings.push_back("method=" + method);
  const auto run = methods().make(tests::read_text(moving_block, settings), {});
  run->advance(1);
  return run->integrals().momentum[1];
}

TEST(shared_damping, acts_in_every_method) {
  for (const std::string method : {"remeshed", "total_lagrangian", "point_based"}) {
    EXPECT_NEAR(momentum(method, {"discretisation.damping=2"}), std::exp(-2), 2e-3) << method;
  }
}

TEST(shared_damping, gives_way_to_that_of_the_method) {
  for (const std::string method : {"total_lagrangian", "point_based"}) {
    for (const std::string own : {"0", "1"}) {
      EXPECT_EQ(momentum(method, {"discretisation.damping=2", method + ".damping=" + own}),
                momentum(method, {method + ".damping=" + own}))
          << method;
    }
  }
}

}  // namespace
}  // namespace pliant::test

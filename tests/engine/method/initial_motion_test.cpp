#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "engine/case/method_rules.hpp"
#include "engine/simulation/methods.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/undeformed/loads.hpp"

namespace pliant::test {
namespace {

/// A body around the origin, 8 spacings across.
Case moving(const std::string& method, int dimension, const std::string& shape,
            const std::string& motion) {
  return tests::read_text(fmt::format(R"toml(dimension = {}
method = "{}"
discretisation.spacing = 0.125
time.end = 1
[[body]]
name = "body"
geometry = {}
material = {{ model = "neo_hookean", youngs_modulus = 100, poissons_ratio = 0.3, density = 1 }}
{}
)toml",
                                      dimension, method, shape, motion));
}

const std::string square = "{ shape = \"box\", lower = [-0.5, -0.5], upper = [0.5, 0.5] }",
                  disc = "{ shape = \"disc\", centre = [0, 0], radius = 0.5 }",
                  ball = "{ shape = \"ball\", centre = [0, 0, 0], radius = 0.5 }";

struct Sheared {
  int dimension;
  std::string shape, velocity;
  double mean_square;  ///< of the velocity
};

TEST(initial_motion, is_warned_of_by_the_share_by_which_the_kinetic_energy_is_too_large) {
  const Sheared bodies[] = {{2, square, R"(["y", 0])", 1. / 12},
                            {2, square, R"([0, "(x + 0.5)^2"])", 1. / 5},
                            {2, disc, R"(["y", 0])", 1. / 16},
                            {3, ball, R"(["y", 0, 0])", 1. / 20}};
  for (const std::string method : {"total_lagrangian", "point_based"}) {
    for (const Sheared& body : bodies) {
      const Case settings =
          moving(method, body.dimension, body.shape, "velocity = " + body.velocity);
      const auto run = methods().make(settings, {1, kernels::widest_supported()});
      const BodyIntegrals start = run->integrals();
      const double error = 200 * start.kinetic_energy / (start.mass * body.mean_square) - 100;
      const std::vector<std::string> warnings = warnings_of_method(settings);
      ASSERT_EQ(warnings.size(), 1) << method << ", " << body.shape << ", " << error;
      double told = 0;
      ASSERT_EQ(
          std::sscanf(warnings[0].c_str(), "body `body` starts with up to %lf %% too much", &told),
          1)
          << warnings[0];
      EXPECT_GT(error, 0.5 * told) << method << ", " << body.shape << body.velocity;
      EXPECT_LT(error, 1.05 * told) << method << ", " << body.shape << body.velocity;
    }
  }
}

TEST(initial_motion, of_rotating_bodies_counts_relative_to_their_mean_velocity) {
  const std::string rotation =
      "velocity = [5, 0, 0]\nrotation = { centre = [0, 0, 0], angular_velocity = [0, 0, 3] }";
  const std::vector<std::string> warnings =
      warnings_of_method(moving("total_lagrangian", 3, ball, rotation));
  ASSERT_EQ(warnings.size(), 1);
  EXPECT_EQ(warnings[0],
            "body `body` starts with up to 10 % too much kinetic energy and angular momentum of "
            "its rotation, as masses of particles on its surface lie too far outside; use a finer "
            "spacing (discretisation.spacing = 0.055 or below) or method = \"remeshed\"");
}

TEST(initial_motion, that_is_uniform_or_remeshed_is_not_warned_of) {
  EXPECT_TRUE(warnings_of_method(moving("point_based", 2, disc, "velocity = [3, 1]")).empty());
  EXPECT_TRUE(warnings_of_method(moving("remeshed", 2, disc, R"(velocity = ["y", 0])")).empty());
}

}  // namespace
}  // namespace pliant::test

#include <gtest/gtest.h>

#include "tests/engine/remeshed/snapshot.hpp"

namespace pliant::test {
namespace {

const std::string disc_alone =
    R"({ name = "disc", geometry = { shape = "disc", centre = [0, 0], radius = 1 }, )"
    R"(rotation = { centre = [0, 0], angular_velocity = "2*pi" }, )"
    R"(material = { model = "linear", youngs_modulus = 100, poissons_ratio = 0.3, density = 1 } })";
const std::string box =
    R"({ name = "box", geometry = { shape = "box", lower = [-0.4, 0.2], upper = [0.8, 1.1] }, )"
    R"(velocity = ["4*y", "x"], material = { model = "reduced_polynomial", )"
    R"(coefficients = [40], compressibility = 0.002, density = 2 } })";

/// The bodies of a case after 20 steps, by their names.
std::map<std::string, Snapshot> after_20_steps(const std::string& bodies) {
  Solver solver(small_case("rotating_cylinder",
                           {"discretisation.spacing=0.1", "remeshing.every=6", "measurement=[]",
                            "time.step=5e-4", "body=[" + bodies + "]"}),
                {2, kernels::widest_supported()});
  advance(solver, 20);
  std::map<std::string, Snapshot> snapshots;
  for (const Body& body : solver.state().bodies) {
    add_body(snapshots[body.name], {body, body.population, body.stage[0]}, Slots::all);
  }
  return snapshots;
}

// Bodies are coupled only by the step: they may even overlap.
TEST(two_bodies, each_moves_as_if_it_were_alone) {
  const auto together = after_20_steps(disc_alone + ", " + box);
  ASSERT_EQ(together.size(), 2u);
  for (const std::string& body : {disc_alone, box}) {
    const auto alone = after_20_steps(body);
    const auto& [name, expected] = *alone.begin();
    EXPECT_EQ(differences(expected, together.at(name)), std::vector<std::string>()) << name;
    EXPECT_GT(expected.at("cell").size(), 200u);
  }
}

}  // namespace
}  // namespace pliant::test

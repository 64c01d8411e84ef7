#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "engine/output/archive/archive.hpp"
#include "engine/simulation/methods.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/output/temporary_folder.hpp"
#include "tests/engine/undeformed/loads.hpp"

// Parts of a body that a wall does not hold meet the walls that hold others, (TL.12).
namespace pliant::test {
namespace {

const std::vector<std::string> methods_with_bonds = {"total_lagrangian", "point_based"};

/// The block of the case squeezed to half of its height, by its end; the sides come against the
/// plates after about 0.012 s.
std::unique_ptr<pliant::Solver> squeezed_block(const std::string& method) {
  const std::vector<std::string> settings = {"method=" + method, "discretisation.spacing=1/32"};
  return methods().make(read_case(PLIANT_SOURCE_DIR "/cases/compression_hyperelastic", settings),
                        {});
}

TEST(held_walls, stop_the_sides_of_a_block_that_they_squeeze) {
  for (const std::string& method : methods_with_bonds) {
    const auto run = squeezed_block(method);
    run->advance(0.02);
    double highest = 0;
    for (const auto& x : run->positions(0)) highest = std::max(highest, std::abs(x[1]));
    EXPECT_NEAR(highest, 0.5, 0.05 / 32) << method;
    // The remeshed method with 128 particles across gives 353.96 J, and 318 J is the work if the
    // sides pass through the plates.
    EXPECT_NEAR(run->energy_budget()->wall_work, 353.96, 0.012 * 353.96) << method;
    EXPECT_NEAR(balance(*run), 208.33, 0.002 * 562) << method;
  }
}

// A cube between plates in 3D.
TEST(held_walls, stop_the_sides_of_a_cube) {
  for (const std::string& method : methods_with_bonds) {
    const std::string text = "method = \"" + method + R"("
dimension = 3
discretisation = { spacing = 0.125 }
time = { end = 0.5 }
[material.gel]
model = "neo_hookean"
density = 1
youngs_modulus = 100
poissons_ratio = 0.45
[[body]]
name = "cube"
material = "gel"
geometry = { shape = "box", lower = [-0.5, -0.5, -0.5], upper = [0.5, 0.5, 0.5] }
)" + half_space("floor", "kind = \"fixed\"", "[0, 0, -0.5]", "[0, 0, 1]") +
                             half_space("plate", "kind = \"moving_wall\"\nvelocity = [0, 0, -1]",
                                        "[0, 0, 0.5]", "[0, 0, -1]");
    const auto run = methods().make(tests::read_text(text), {});
    run->advance(0.5);
    double lowest = 0, highest = -1;
    for (const auto& x : run->positions(0)) {
      lowest = std::min(lowest, x[2]);
      highest = std::max(highest, x[2]);
    }
    EXPECT_NEAR(lowest, -0.5, 0.05 * 0.125) << method;
    EXPECT_NEAR(highest, 0, 0.05 * 0.125) << method;
  }
}

// A flat slip wall is a plane of symmetry, which the other half of the body would not pass either.
TEST(held_walls, are_met_as_planes_of_symmetry_are) {
  for (const std::string& method : methods_with_bonds) {
    const std::string text =
        tests::rubber_case(method, 2, "0.05", "1") + R"([[body]]
name = "arch"
material = "rubber"
geometry = { shape = "difference", of = [
  { shape = "box", lower = [0, 0], upper = [1, 1] },
  { shape = "box", lower = [0, -1], upper = [0.6, 0.7] },
] }
)" + half_space("symmetry", "kind = \"slip_wall\"", "[0, 0]", "[1, 0]") +
        "[[boundary]]\nname = \"push\"\nkind = \"traction\"\ntraction = [\"-20*t\", 0]\n"
        "geometry = { shape = \"box\", lower = [0.9, -1], upper = [2, 0.4] }\n";
    const auto run = methods().make(tests::read_text(text), {});
    double leftmost = 1;
    bool has_met = false;
    for (int sample = 1; sample <= 40; ++sample) {
      run->advance(0.025 * sample);
      for (const auto& x : run->positions(0)) {
        leftmost = std::min(leftmost, x[0]);
        has_met = has_met || (x[0] < 0.01 && x[1] < 0.5);
      }
    }
    EXPECT_TRUE(has_met) << method;
    EXPECT_GT(leftmost, -0.05 * 0.05) << method;
  }
}

// The lists of corners near walls are part of the state.
TEST(held_walls, are_met_alike_after_a_restart) {
  const TemporaryFolder folder;
  for (const std::string& method : methods_with_bonds) {
    const auto whole = squeezed_block(method);
    while (whole->clock().time < 0.015) whole->step(HUGE_VAL);
    ArchiveWriter writer(folder / method);
    whole->save(writer);
    writer.commit();
    const auto resumed = squeezed_block(method);
    resumed->restore(ArchiveReader(folder / method));
    for (int step = 0; step < 20; ++step) {
      whole->step(HUGE_VAL);
      resumed->step(HUGE_VAL);
    }
    EXPECT_EQ(resumed->positions(0), whole->positions(0)) << method;
    EXPECT_EQ(resumed->energy_budget()->wall_work, whole->energy_budget()->wall_work) << method;
  }
}

}  // namespace
}  // namespace pliant::test

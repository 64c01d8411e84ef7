#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "engine/case/method_rules.hpp"
#include "engine/simulation/methods.hpp"
#include "tests/engine/finite_elements/meshed_block.hpp"
#include "tests/engine/undeformed/loads.hpp"

namespace pliant::test {
namespace {

/// Walls that pull a block of 6 cells, [0, 1]^3, by 0.1 m, and overlap it by `depth`.
Case pulled_block(const std::string& method, const std::filesystem::path& mesh, double depth) {
  write(unit_block<3>(6), mesh);
  return tests::read_text(
      meshed_block(mesh) +
          half_space("floor", "kind = \"fixed\"", fmt::format("[0, {}, 0]", depth), "[0, 1, 0]") +
          half_space("top", "kind = \"moving_wall\"\ndisplacement = [0, \"0.1*min(t, 1)\", 0]",
                     fmt::format("[0, {}, 0]", 1 - depth), "[0, -1, 0]") +
          measurement("force", "kind = \"wall_force\"\nboundary = \"floor\"\naxis = \"y\"") +
          measurement("energy", "kind = \"strain_energy\""),
      {"method=" + method, "discretisation.damping=adaptive", "time.end=2"});
}

// Walls that cut elements hold the nodes inside them, so that the block is as stiff as between
// walls at its ends. It had come off in the point-based method.
TEST(walls_in_meshes, hold_the_nodes_inside_them) {
  TemporaryFolder folder;
  for (const std::string method : {"finite_elements", "point_based"}) {
    double energy[2];
    for (const bool cuts : {false, true}) {
      const Case settings = pulled_block(method, folder / "block.vtk", cuts ? 0.07 : 0);
      const auto run = methods().make(settings, {2, kernels::widest_supported()});
      run->advance(2);
      energy[cuts] = values(*run)["energy"];
      const std::vector<std::string> warnings = warnings_of_method(settings);
      EXPECT_EQ(
          std::ranges::count_if(warnings,
                                [](const std::string& warning) {
                                  return warning.find("0.07 m inside it: it is about 7.5 %") !=
                                         std::string::npos;
                                }),
          cuts ? 2 : 0)
          << method;
    }
    EXPECT_NEAR(energy[1] / energy[0], 1, 0.01) << method;
  }
}

}  // namespace
}  // namespace pliant::test

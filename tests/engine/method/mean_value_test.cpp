#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "engine/simulation/methods.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/undeformed/loads.hpp"

namespace pliant::test {
namespace {

// The mean of a velocity y over 0.1 < y < 0.7. If particles counted as a whole or not at all, it
// would be off by up to 7 % with 7 particles across.
TEST(mean_value, of_a_region_does_not_depend_on_where_its_border_lies_between_particles) {
  for (const int dimension : {2, 3}) {
    for (const std::string method : {"remeshed", "total_lagrangian", "point_based"}) {
      for (const int across : {7, 8, 9, 10}) {
        const bool flat = dimension == 2;
        const auto run = methods().make(
            tests::read_text(
                fmt::format(R"toml(dimension = {}
method = "{}"
discretisation.spacing = "1/{}"
time.end = 1
[[body]]
name = "block"
geometry = {{ shape = "box", lower = {}, upper = {} }}
material = {{ model = "neo_hookean", youngs_modulus = 100, poissons_ratio = 0.3, density = 1 }}
velocity = {}
)toml",
                            dimension, method, across, flat ? "[0, 0]" : "[0, 0, 0]",
                            flat ? "[1, 1]" : "[1, 1, 1]",
                            flat ? R"([0, "y"])" : R"([0, "y", 0])") +
                measurement("mean",
                            "kind = \"mean_value\"\nfield = \"velocity_y\"\nwhere = \"y > 0.1 && "
                            "y < 0.7\"")),
            {1, kernels::widest_supported()});
        EXPECT_NEAR(values(*run)["mean"], 0.4, 0.012) << method << ", " << across;
      }
    }
  }
}

}  // namespace
}  // namespace pliant::test

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "engine/case/method_rules.hpp"
#include "tests/engine/case/written_case.hpp"

namespace pliant::test {
namespace {

bool tells_of_equation_of_state(const std::string& method, const std::string& equation) {
  const Case settings = tests::read_text(fmt::format(R"toml(method = "{}"
dimension = 2
discretisation.spacing = 0.05
time.end = 1
[[body]]
name = "block"
geometry = {{ shape = "box", lower = [0, 0], upper = [1, 1] }}
[body.material]
model = "linear"
equation_of_state = "{}"
youngs_modulus = 100
poissons_ratio = 0.3
density = 1
)toml",
                                                     method, equation));
  return std::ranges::any_of(warnings_of_method(settings), [](const std::string& w) {
    return w.find("equation_of_state = \"logarithmic\" has no effect") != std::string::npos;
  });
}

TEST(linear_material, without_its_equation_of_state_is_warned_of) {
  EXPECT_TRUE(tells_of_equation_of_state("point_based", "logarithmic"));
  EXPECT_FALSE(tells_of_equation_of_state("point_based", "linear"));
  EXPECT_FALSE(tells_of_equation_of_state("total_lagrangian", "logarithmic"));
}

}  // namespace
}  // namespace pliant::test

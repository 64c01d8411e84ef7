#include "engine/case/checks/short_runs.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "tests/engine/case/written_case.hpp"

namespace pliant {
namespace {

/// A body with waves of 10 m/s, on particles of 0.1 m.
std::vector<std::string> short_run_warnings(double end, bool has_wall) {
  const Case a_case = tests::read_text(fmt::format(
      "dimension = 2\ndiscretisation.spacing = 0.1\ntime.end = {}\n[[body]]\nname = \"it\"\n"
      "geometry = {{ shape = \"box\", lower = [0, 0], upper = [1, 1] }}\nmaterial = {{ model = "
      "\"linear\", youngs_modulus = 100, poissons_ratio = 0, density = 1 }}\n{}",
      end,
      has_wall ? "[[boundary]]\nname = \"piston\"\nkind = \"moving_wall\"\nvelocity = [0, 1]\n"
                 "geometry = { shape = \"half_space\", point = [0, 0], normal = [0, 1] }\n"
               : ""));
  std::vector<std::string> warnings;
  warn_of_short_runs(a_case, warnings);
  return warnings;
}

TEST(short_runs, at_walls_are_warned_of) {
  EXPECT_EQ(short_run_warnings(0.05, true),
            std::vector<std::string>{
                "waves pass through no more than 5 spacings until the run ends: displacements that "
                "begin with it deviate by 5 % or more; use a finer spacing (discretisation.spacing "
                "= 0.0833 or below)"});
  EXPECT_TRUE(short_run_warnings(0.07, true).empty());
  EXPECT_TRUE(short_run_warnings(0.05, false).empty());
}

}  // namespace
}  // namespace pliant

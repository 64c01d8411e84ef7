#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "engine/simulation/methods.hpp"
#include "tests/engine/undeformed/loads.hpp"

// The cases of docs/validation/methods.md, by methods with different nodes and gradients.
namespace pliant::test {
namespace {

struct Answer {
  double displacement, strain_energy, work;
};

Answer answer(const std::string& name, const std::string& method) {
  const std::string file = PLIANT_SOURCE_DIR "/docs/validation/methods/" + name + ".toml";
  const auto run =
      methods().make(read_case(file, std::vector<std::string>{"method=" + method}), {2});
  run->advance(run->settings().time.end);
  auto measured = values(*run);
  return {measured["displacement"], measured["strain_energy"], run->energy_budget()->work()};
}

TEST(methods, agree_on_large_strains) {
  for (const std::string name : {"squeezed", "stretched", "twisted", "indented", "loaded"}) {
    const Answer cells = answer(name, "total_lagrangian"), points = answer(name, "point_based");
    constexpr double bar = 0.02;
    EXPECT_NEAR(points.displacement / cells.displacement, 1, bar) << name;
    EXPECT_NEAR(points.strain_energy / cells.strain_energy, 1, bar) << name;
    EXPECT_NEAR(points.work / cells.work, 1, bar) << name;
  }
}

}  // namespace
}  // namespace pliant::test

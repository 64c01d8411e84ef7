#include "engine/method/step_failure.hpp"

#include <gtest/gtest.h>

#include "engine/simulation/methods.hpp"
#include "engine/total_lagrangian/parameters.hpp"
#include "tests/engine/case/written_case.hpp"

namespace pliant::test {
namespace {

std::string failure(const std::vector<std::string>& settings) {
  StepClock clock;
  clock.time = 0.5;
  clock.step = 7;
  const Case a_case = tests::read_text(tests::block_case, settings);
  return failed_step(a_case, clock, "the block broke", {smaller_step(a_case), "pray"}).what();
}

TEST(failed_step, names_the_key_that_sets_the_step_of_the_case) {
  EXPECT_EQ(failure({}),
            "t = 0.5, step 7: the block broke; use a smaller time step (time.cfl), or pray");
  EXPECT_EQ(failure({"time.step=0.001"}),
            "t = 0.5, step 7: the block broke; use a smaller time step (time.step), or pray");
}

TEST(failed_step, names_a_step_above_the_stability_limit_as_the_cause) {
  EXPECT_EQ(failure({"time.step=0.05"}),
            "t = 0.5, step 7: the block broke; the time step 0.05 s is above the stability limit "
            "of 0.0207 s (CFL number 1.7); set time.step = \"cfl\", or to less than the limit");
}

TEST(failed_step, names_the_mass_scaling_where_that_follows_the_step) {
  Case a_case = tests::read_text(tests::block_case, {"time.step=1"});
  a_case.rules = &methods().find("total_lagrangian").rules;
  a_case.parameters.as<total_lagrangian::Parameters>().mass_scaling.reset();
  EXPECT_EQ(smaller_step(a_case), "scale the mass more (a smaller time.cfl)");
}

TEST(failed_step, names_places_by_all_their_coordinates) {
  EXPECT_EQ(coordinates<2>({0.5, -1}), "(0.5, -1)");
  EXPECT_EQ(coordinates<3>({0.5, -1, 2.25}), "(0.5, -1, 2.25)");
}

}  // namespace
}  // namespace pliant::test

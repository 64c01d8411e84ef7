#include "engine/simulation/default_samples.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "engine/simulation/methods.hpp"
#include "tests/engine/case/written_case.hpp"

namespace pliant::test {
namespace {

/// The steps at which a block of this case is sampled until the end.
std::vector<std::int64_t> steps_sampled(double step, const std::string& more) {
  Case settings = tests::read_text("method = \"total_lagrangian\"\n" + tests::block_case + more);
  settings.time.step = step;
  settings.time.end = 1;
  const auto run = methods().make(settings, {});
  DefaultSamples samples(run->settings());
  std::vector<std::int64_t> steps;
  while (run->clock().time < 1) {
    run->step(1 - run->clock().time);
    if (samples.due(*run)) steps.push_back(run->clock().step);
  }
  return steps;
}

const std::string largest_speed =
    "[[measurement]]\nname = \"k\"\nkind = \"kinetic_energy\"\n"
    "[[measurement]]\nname = \"l\"\nkind = \"largest\"\nof = \"k\"\n";

TEST(default_samples, are_a_hundred_but_not_in_successive_steps) {
  EXPECT_EQ(steps_sampled(1. / 1600, largest_speed).size(), 100u);
  const std::vector<std::int64_t> few = steps_sampled(1. / 64, largest_speed);
  EXPECT_EQ(few, (std::vector<std::int64_t>{8, 16, 24, 32, 40, 48, 56, 64}));
  EXPECT_TRUE(steps_sampled(1. / 64, "").empty());
}

TEST(default_samples, continue_after_the_last_one) {
  Case settings =
      tests::read_text("method = \"total_lagrangian\"\n" + tests::block_case + largest_speed);
  settings.time.step = 1. / 64;
  settings.time.end = 1;
  const auto run = methods().make(settings, {});
  run->advance(0.125);
  DefaultSamples samples(run->settings()), restored(run->settings());
  EXPECT_TRUE(samples.due(*run));
  restored.restore(0.125);
  EXPECT_FALSE(restored.due(*run));
}

}  // namespace
}  // namespace pliant::test

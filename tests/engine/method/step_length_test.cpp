#include "engine/method/step_length.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/method/step_failure.hpp"

namespace pliant::test {
namespace {

double length(double asked, double longest) {
  Case settings;
  settings.time.end = 1;
  StepClock clock;
  clock.time = 0.5;
  clock.wave_speed = 20;
  return step_length(settings, clock, asked, longest);
}

TEST(step_length, is_what_is_asked_for_or_what_time_is_left) {
  EXPECT_EQ(length(0.01, 0.5), 0.01);
  EXPECT_EQ(length(0.01, 0.004), 0.004);
}

TEST(step_length, leaves_no_step_that_rounding_alone_would_make) {
  const double longest = 0.01 * (1 + 1e-12);
  EXPECT_EQ(length(0.01, longest), longest);
}

TEST(step_length, fails_where_waves_leave_no_time) {
  for (const double asked : {1e-13, 0.0, -1.0, std::nan("")}) {
    try {
      length(asked, 0.5);
      FAIL() << "a step of " << asked;
    } catch (const StepFailure& failure) {
      EXPECT_NE(std::string(failure.what()).find("t = 0.5: the time step has collapsed"),
                std::string::npos)
          << failure.what();
    }
  }
}

}  // namespace
}  // namespace pliant::test

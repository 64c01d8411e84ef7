#include "engine/simulation/pulse.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace pliant::test {
namespace {

/// Half a wave of sin(pi t), then zero, as means over samples of length `step`.
struct Pulse {
  std::vector<double> time{0}, value{0};

  Pulse(double step, double end) {
    const double pi = std::acos(-1.0);
    const auto integral = [&](double t) { return (1 - std::cos(pi * std::min(t, 1.0))) / pi; };
    for (int i = 1; i * step <= end; ++i) {
      time.push_back(i * step);
      value.push_back((integral(i * step) - integral((i - 1) * step)) / step);
    }
  }
};

TEST(pulses, peak_moving_average_of_a_half_wave_is_that_of_its_top) {
  const double pi = std::acos(-1.0);
  const Pulse pulse(1 / 64., 2);
  // Windows that end at samples: one of them is centred at the maximum.
  for (const double over : {2 / 64., 8 / 64., 1.0}) {
    const double exact = std::sin(pi * over / 2) / (pi * over / 2);
    EXPECT_NEAR(peak_moving_average(pulse.time, pulse.value, over), exact, 1e-12) << over;
  }
}

TEST(pulses, peak_moving_average_waits_for_its_first_window) {
  const Pulse pulse(0.125, 0.5);
  EXPECT_TRUE(std::isnan(peak_moving_average(pulse.time, pulse.value, 0.6)));
  EXPECT_FALSE(std::isnan(peak_moving_average(pulse.time, pulse.value, 0.5)));
}

TEST(pulses, last_time_above_is_the_end_of_a_half_wave_within_a_sample) {
  for (const double step : {0.1, 0.01}) {
    const Pulse pulse(step, 2);
    // The last 0.03 % of the wave are below a thousandth.
    EXPECT_NEAR(last_time_above(pulse.time, pulse.value, 0.001), 1, 1.001 * step) << step;
  }
}

TEST(pulses, last_time_above_a_half_is_where_the_wave_falls_below_it) {
  const Pulse pulse(0.01, 2);
  EXPECT_NEAR(last_time_above(pulse.time, pulse.value, 0.5), 5. / 6, 0.011);  // sin(5 pi/6) = 1/2
}

// The force on the other body, or of a wall on the other side, has the opposite sign.
TEST(pulses, of_opposite_sign_have_the_same_times_and_the_opposite_peak) {
  const Pulse pulse(1 / 64., 2);
  std::vector<double> opposite = pulse.value;
  for (double& value : opposite) value = -value;
  EXPECT_EQ(peak_moving_average(pulse.time, opposite, 0.125),
            -peak_moving_average(pulse.time, pulse.value, 0.125));
  EXPECT_EQ(last_time_above(pulse.time, opposite, 0.001),
            last_time_above(pulse.time, pulse.value, 0.001));
}

TEST(pulses, of_both_signs_peak_where_their_magnitude_is_largest) {
  const std::vector<double> time = {0, 1, 2, 3}, value = {0, 2, -3, 1};
  EXPECT_EQ(peak_moving_average(time, value, 1), -3);
  EXPECT_EQ(last_time_above(time, value, 0.5), 2);
}

TEST(pulses, that_are_zero_throughout_have_no_last_time_above) {
  const std::vector<double> time = {0, 1, 2}, value = {0, 0, 0};
  EXPECT_TRUE(std::isnan(last_time_above(time, value, 0.001)));
}

}  // namespace
}  // namespace pliant::test

#include "engine/simulation/oscillation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace pliant::test {
namespace {

constexpr double pi = 3.14159265358979323846;

/// Samples of a function of time at intervals of `step`.
struct Signal {
  std::vector<double> time, value;

  Signal(double end, double step, const std::function<double(double)>& f) {
    for (int i = 0; i * step <= end; ++i) {
      time.push_back(i * step);
      value.push_back(f(i * step));
    }
  }

  double period() const { return oscillation_period(time, value); }
  double ratio() const { return amplitude_ratio(time, value); }
};

TEST(oscillations, period_of_a_sine_is_found_within_the_square_of_the_sampling_interval) {
  for (const double phase : {0.0, 0.4, 2.0}) {
    const auto wave = [&](double t) { return 0.01 * std::sin(2 * pi * t / 5.94 + phase); };
    // A chord between samples misses a zero by up to 0.07 w^2 dt^3; the mean over 3 spacings by
    // less.
    EXPECT_NEAR(Signal(14, 0.1, wave).period(), 5.94, 0.07 * 1.12 * 1e-3) << phase;
  }
}

TEST(oscillations, amplitude_ratio_of_a_decaying_sine_is_its_decay_in_a_period) {
  for (const double decay : {0.0, 0.05, 0.3}) {
    const auto wave = [&](double t) { return std::exp(-decay * t) * std::sin(2 * pi * t); };
    // The parabola through three samples misses the maximum by about (w dt)^4/384, always the same.
    EXPECT_NEAR(Signal(4.3, 0.01, wave).ratio(), std::exp(-decay), 1e-6) << decay;
  }
}

// Bodies under gravity swing about their state of rest, and high modes ride on the swing.
TEST(oscillations, about_another_level_and_under_high_modes_have_the_same_period_and_ratio) {
  for (const double decay : {0.0, 0.2}) {
    const auto swing = [&](double t) {
      return -0.06 + 0.06 * std::exp(-decay * t) * std::cos(2 * pi * t);
    };
    EXPECT_NEAR(Signal(4.3, 0.01, swing).period(), 1, 0.002) << decay;
    EXPECT_NEAR(Signal(4.3, 0.01, swing).ratio(), std::exp(-decay), 1e-3) << decay;
    const auto rough = [&](double t) { return swing(t) + 0.002 * std::sin(51 * t); };
    EXPECT_NEAR(Signal(4.3, 0.01, rough).period(), 1, 0.01) << decay;
    EXPECT_NEAR(Signal(4.3, 0.01, rough).ratio(), std::exp(-decay), 0.05) << decay;
  }
}

TEST(oscillations, a_sample_that_is_exactly_zero_is_a_crossing_on_the_way_down_and_up) {
  const std::vector<double> time = {0, 1, 2, 3, 4, 5, 6, 7, 8};
  const std::vector<double> value = {1, 0, -1, 0, 1, 0, -1, 0, 1};
  EXPECT_EQ(oscillation_period(time, value), 4);
  EXPECT_EQ(amplitude_ratio(time, value), 1);
}

TEST(oscillations, a_start_from_rest_at_zero_is_not_a_crossing_but_its_swing_counts) {
  const auto wave = [](double t) { return std::sin(2 * pi * t); };
  const Signal half(0.9, 0.01, wave);  // one crossing, at t = 1/2
  EXPECT_TRUE(std::isnan(half.period()));
  const Signal longer(1.6, 0.01, wave);  // extrema at 1/4, 3/4, 5/4
  EXPECT_NEAR(longer.ratio(), 1, 1e-6);
}

TEST(oscillations, without_two_crossings_or_two_like_extrema_there_is_no_value) {
  EXPECT_TRUE(std::isnan(oscillation_period({}, {})));
  EXPECT_TRUE(std::isnan(amplitude_ratio({}, {})));
  const Signal growing(3, 0.1, [](double t) { return 1 + t; });
  EXPECT_TRUE(std::isnan(growing.period()));
  EXPECT_TRUE(std::isnan(growing.ratio()));
  const Signal short_wave(1.2, 0.01, [](double t) { return std::cos(2 * pi * t); });
  EXPECT_NEAR(short_wave.period(), 1, 1e-5);
  EXPECT_TRUE(std::isnan(short_wave.ratio()));
}

}  // namespace
}  // namespace pliant::test

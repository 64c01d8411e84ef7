#include "kernels/remeshed/stage/runge_kutta.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace pliant::kernels {
namespace {

using P = xsimd::batch<double, xsimd::sse2>;
using State = std::array<double, 2>;  // (position, velocity) of a pendulum, one register

State rate_of(const State& q) { return {q[1], -std::sin(q[0])}; }

State textbook_step(const State& q, double dt) {
  const auto moved = [&](const State& k, double by) {
    return State{q[0] + by * k[0], q[1] + by * k[1]};
  };
  const State k1 = rate_of(q), k2 = rate_of(moved(k1, dt / 2)), k3 = rate_of(moved(k2, dt / 2)),
              k4 = rate_of(moved(k3, dt));
  State next;
  for (int i = 0; i < 2; ++i) next[i] = q[i] + dt / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  return next;
}

/// With three copies of the state, as in the engine.
State step(State start, double dt) {
  State second, third;
  const auto advance = [&]<StagePlace place>(const State& current, State& next) {
    const StageField<double> field{current.data(), start.data(), second.data(), third.data(),
                                   next.data()};
    RungeKutta<P, place>(dt).advance(field, 0, load<P>(rate_of(current).data()));
  };
  advance.operator()<StagePlace::early>(start, second);
  advance.operator()<StagePlace::early>(second, third);
  advance.operator()<StagePlace::third>(third, second);
  advance.operator()<StagePlace::last>(second, start);
  return start;
}

TEST(runge_kutta, with_three_copies_is_the_textbook_method) {
  State q = {1, 0.3}, textbook = q;
  for (int n = 0; n < 100; ++n) {
    q = step(q, 0.1);
    textbook = textbook_step(textbook, 0.1);
  }
  // A few units of rounding in each of 100 steps.
  EXPECT_NEAR(q[0], textbook[0], 1e-13);
  EXPECT_NEAR(q[1], textbook[1], 1e-13);
}

TEST(runge_kutta, is_of_fourth_order) {
  const auto end = [](int steps) {
    State q = {1, 0.3};
    for (int n = 0; n < steps; ++n) q = step(q, 2. / steps);
    return q[0];
  };
  const double exact = end(4000);
  const double order = std::log2(std::abs(end(20) - exact) / std::abs(end(40) - exact));
  EXPECT_NEAR(order, 4, 0.2);
}

TEST(runge_kutta, what_does_not_change_keeps_its_bits) {
  for (double x = 0.1; x < 10; x += 0.0371) {
    std::array<double, 2> q = {x, -x}, start = q, next;
    const StageField<double> field{q.data(), start.data(), q.data(), q.data(), next.data()};
    RungeKutta<P, StagePlace::third>(0.1).advance(field, 0, P(0.));
    EXPECT_EQ(next, q);
    EXPECT_EQ(start, q);
    RungeKutta<P, StagePlace::last>(0.1).advance(field, 0, P(0.));
    EXPECT_EQ(next, q);
  }
}

}  // namespace
}  // namespace pliant::kernels

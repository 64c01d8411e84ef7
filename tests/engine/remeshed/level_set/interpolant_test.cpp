#include "engine/remeshed/level_set/interpolant.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/engine/remeshed/level_set/node_values.hpp"

namespace pliant::test {
namespace {

using remeshed::CubicInterpolant;

template <int D>
CubicInterpolant<double, D> interpolant(const NodeValues<D>& nodes) {
  return {nodes.lattice, nodes.layout, nodes.values.data()};
}

/// A polynomial of degree 3 in each direction, with all mixed terms, and its gradient.
template <int D>
double cubic(const Point<D>& x) {
  double product = 1;
  for (int a = 0; a < D; ++a) {
    const double s = x[a] / 8 - 0.6 - 0.1 * a;
    product *= 0.4 + s - 2 * s * s + 1.5 * s * s * s;
  }
  return product;
}

template <class Space>
struct CubicInterpolation : testing::Test {};
TYPED_TEST_SUITE(CubicInterpolation, Dimensions);

TYPED_TEST(CubicInterpolation, cubics_and_their_gradients_are_exact) {
  constexpr int D = TypeParam::dimension;
  const Cell<D> upper = diagonal<D>(15);
  const NodeValues<D> nodes(upper, {}, cubic<D>);
  const auto interpolate = interpolant(nodes);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(1, 13.99);
  for (int i = 0; i < 200; ++i) {
    Point<D> x, gradient;
    for (double& component : x) component = anywhere(random);
    double value = 0;
    ASSERT_TRUE(interpolate(x, value, gradient));
    EXPECT_NEAR(value, cubic<D>(x), 1e-13);
    for (int a = 0; a < D; ++a) {
      Point<D> up = x, down = x;
      const double step =
          1e-3;  // the error of the reference is step^2/6 times a third derivative of 0.02
      up[a] += step;
      down[a] -= step;
      EXPECT_NEAR(gradient[a], (cubic<D>(up) - cubic<D>(down)) / (2 * step), 1e-8);
    }
  }
}

TYPED_TEST(CubicInterpolation, nodes_give_their_values) {
  constexpr int D = TypeParam::dimension;
  const NodeValues<D> nodes(diagonal<D>(7), {},
                            [](const Point<D>& x) { return std::sin(x[0] + 2 * x[D - 1]); });
  for_each_cell<D>(diagonal<D>(1), diagonal<D>(5), [&](const Cell<D>& cell) {
    Point<D> x, gradient;
    std::copy(cell.begin(), cell.end(), x.begin());
    double value = 0;
    ASSERT_TRUE(interpolant(nodes)(x, value, gradient));
    EXPECT_EQ(value, nodes.values[nodes.layout.slot(cell)]);
  });
}

TYPED_TEST(CubicInterpolation, has_no_value_where_a_node_is_missing) {
  constexpr int D = TypeParam::dimension;
  const NodeValues<D> nodes(diagonal<D>(7), {}, cubic<D>);
  for (int a = 0; a < D; ++a) {
    Point<D> x, gradient;
    x.fill(3.5);
    double value = 0;
    for (const double outside : {0.99, 6.01}) {
      x[a] = outside;
      EXPECT_FALSE(interpolant(nodes)(x, value, gradient)) << a << ": " << outside;
    }
  }
}

TYPED_TEST(CubicInterpolation, runs_on_through_a_period) {
  constexpr int D = TypeParam::dimension;
  const Cell<D> period = diagonal<D>(16);
  const auto wave = [](const Point<D>& x) {
    const double k = 2 * std::acos(-1.0) / 16;
    return std::sin(k * x[0]) * std::cos(k * x[1]);
  };
  const NodeValues<D> nodes(diagonal<D>(15), period, wave);
  for (double s = -3; s < 19; s += 0.13) {
    Point<D> x, gradient;
    x.fill(s);
    double value = 0;
    ASSERT_TRUE(interpolant(nodes)(x, value, gradient)) << s;
    // 3/128 (k h)^4 in each direction, with k h = 0.39.
    EXPECT_NEAR(value, wave(x), 2 * 3.0 / 128 * std::pow(0.3927, 4)) << s;
  }
}

}  // namespace
}  // namespace pliant::test

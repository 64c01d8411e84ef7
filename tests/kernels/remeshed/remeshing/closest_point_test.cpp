#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/kernels/nodes_of_a_ball.hpp"
#include "tests/kernels/tables.hpp"

namespace pliant::kernels::test {
namespace {

template <class T>
class closest_point : public testing::Test {};
TYPED_TEST_SUITE(closest_point, Dimensions);

/// The largest distance [cells] of a computed point from the exact one, which is on the line from
/// the centre of the ball through its node.
template <class T, int D>
double largest_error(NodesOfABall<T, D> ball) {
  baseline_table<T, D>().find_closest_points(ball.arguments());
  double largest = 0;
  for (int i = 0; i < ball.count; ++i) {
    EXPECT_EQ(ball.converged[i], 1);
    const double from_centre = ball.distance_from_centre(ball.node, i);
    double square = 0;
    for (int a = 0; a < D; ++a) {
      const double centre = ball.centre(a);
      const double expected = centre + ball.radius / from_centre * (ball.node[a][i] - centre);
      square += std::pow(ball.point[a][i] - expected, 2);
    }
    largest = std::max(largest, std::sqrt(square));
  }
  return largest;
}

// The gradient of a cubic interpolant is of third order.
TYPED_TEST(closest_point, converges_to_that_of_a_ball) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  const double coarse = largest_error(NodesOfABall<T, D>(6.3));
  const double fine = largest_error(NodesOfABall<T, D>(12.6));
  EXPECT_GT(std::log2(coarse / fine), 2.8) << coarse << ", " << fine;
}

TYPED_TEST(closest_point, is_not_found_where_nodes_are_missing) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  NodesOfABall<T, D> ball(6.3);
  for (T& value : ball.values) value = std::numeric_limits<T>::quiet_NaN();
  baseline_table<T, D>().find_closest_points(ball.arguments());
  for (int i = 0; i < ball.count; ++i) EXPECT_EQ(ball.converged[i], 0);
}

TYPED_TEST(closest_point, is_not_sought_outside_the_box) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  NodesOfABall<T, D> ball(6.3);
  for (T& x : ball.point[0]) x = T(-40);
  baseline_table<T, D>().find_closest_points(ball.arguments());
  for (int i = 0; i < ball.count; ++i) {
    EXPECT_EQ(ball.converged[i], 0);
    EXPECT_EQ(ball.point[0][i], T(-40));
  }
}

}  // namespace
}  // namespace pliant::kernels::test

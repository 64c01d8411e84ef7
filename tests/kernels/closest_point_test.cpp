#include <cmath>
#include <limits>

#include "tests/kernels/nodes_of_a_ball.hpp"
#include "tests/kernels/tables.hpp"

namespace pliant::kernels::test {
namespace {

template <class T>
class closest_point : public testing::Test {};
TYPED_TEST_SUITE(closest_point, Dimensions);

TYPED_TEST(closest_point, lies_on_the_line_from_the_centre_of_a_ball_through_the_node) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  NodesOfABall<T, D> ball;
  baseline_table<T, D>().find_closest_points(ball.arguments());
  for (int i = 0; i < ball.count; ++i) {
    EXPECT_EQ(ball.converged[i], 1);
    const double from_centre = ball.distance_from_centre(ball.node, i);
    for (int a = 0; a < D; ++a) {
      const double centre = ball.centre(a);
      const double expected = centre + ball.radius / from_centre * (ball.node[a][i] - centre);
      EXPECT_NEAR(ball.point[a][i], expected, 5e-3);  // of a ball of six cells
    }
  }
}

TYPED_TEST(closest_point, is_not_found_where_nodes_are_missing) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  NodesOfABall<T, D> ball;
  for (T& value : ball.values) value = std::numeric_limits<T>::quiet_NaN();
  baseline_table<T, D>().find_closest_points(ball.arguments());
  for (int i = 0; i < ball.count; ++i) EXPECT_EQ(ball.converged[i], 0);
}

TYPED_TEST(closest_point, is_not_sought_outside_the_box) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  NodesOfABall<T, D> ball;
  for (T& x : ball.point[0]) x = T(-40);
  baseline_table<T, D>().find_closest_points(ball.arguments());
  for (int i = 0; i < ball.count; ++i) {
    EXPECT_EQ(ball.converged[i], 0);
    EXPECT_EQ(ball.point[0][i], T(-40));
  }
}

}  // namespace
}  // namespace pliant::kernels::test

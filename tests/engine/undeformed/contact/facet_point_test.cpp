#include "engine/undeformed/contact/facet_point.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

// Nearest points of facets, compared with a search over many points of the facet.
namespace pliant::undeformed {
namespace {

TEST(facet_point, is_the_nearest_point_of_a_segment) {
  const std::array<Point<2>, 2> segment = {Point<2>{0.1, 0.2}, Point<2>{0.9, -0.3}};
  for (const Point<2>& x : {Point<2>{0.5, 0.5}, Point<2>{-1, 0.4}, Point<2>{2, -2}}) {
    const Point<2> way = way_from<2>(segment, nearest_weights(segment, x), x);
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= 1000; ++i) {
      const double t = i / 1000.;
      const Point<2> other = way_from<2>(segment, {1 - t, t}, x);
      least = std::min(least, std::hypot(other[0], other[1]));
    }
    // The sample next to the nearest one is 1e-3 lengths away, with an error of second order.
    EXPECT_NEAR(std::hypot(way[0], way[1]), least, 1e-6);
  }
}

TEST(facet_point, is_the_nearest_point_of_a_triangle) {
  const std::array<Point<3>, 3> triangle = {Point<3>{0, 0, 0}, Point<3>{1, 0.1, 0.2},
                                            Point<3>{0.3, 0.9, -0.1}};
  for (const Point<3>& x : {Point<3>{0.4, 0.3, 0.8}, Point<3>{-1, -1, 0.5}, Point<3>{2, 0.2, 0},
                            Point<3>{0.8, 0.8, -0.4}}) {
    const std::array<double, 3> weight = nearest_weights(triangle, x);
    EXPECT_NEAR(weight[0] + weight[1] + weight[2], 1, 1e-15);
    const Point<3> way = way_from<3>(triangle, weight, x);
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= 400; ++i) {
      for (int j = 0; i + j <= 400; ++j) {
        const double s = i / 400., t = j / 400.;
        const Point<3> other = way_from<3>(triangle, {1 - s - t, s, t}, x);
        least = std::min(least, dot<3>(other, other));
      }
    }
    EXPECT_NEAR(std::sqrt(dot<3>(way, way)), std::sqrt(least), 1e-5);
  }
}

}  // namespace
}  // namespace pliant::undeformed

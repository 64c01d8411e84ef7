#include "engine/geometry/reentrant_corner.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/geometry/shapes.hpp"

namespace pliant {
namespace {

using tests::ball;
using tests::box;
using tests::combine;

bool has_corner(const Shape& shape, int dimension) {
  return has_reentrant_corner(shape, shape, dimension, 0.1);
}

TEST(reentrant_corner, is_found_in_brackets_notches_and_where_balls_meet) {
  constexpr auto unite = Shape::Kind::unite, subtract = Shape::Kind::subtract;
  const Shape leg = box({0, 0, 0}, {1, 3, 1}), arm = box({0, 2, 0}, {3, 3, 1});
  const Shape balls = combine(unite, {ball({0, 0, 0}, 1), ball({1.5, 0, 0}, 1)});
  const Shape notch = combine(subtract, {arm, box({1.2, 2.6, -1}, {1.8, 4, 2})});
  for (const int dimension : {2, 3}) {
    EXPECT_TRUE(has_corner(combine(unite, {leg, arm}), dimension)) << dimension;
    EXPECT_TRUE(has_corner(notch, dimension)) << dimension;
    EXPECT_TRUE(has_corner(balls, dimension)) << dimension;
  }
}

TEST(reentrant_corner, is_neither_an_edge_nor_a_round_hole) {
  const Shape block = box({0, 0, 0}, {1, 3, 1});
  const Shape ring = combine(Shape::Kind::subtract, {ball({0, 0, 0}, 1), ball({0, 0, 0}, 0.5)});
  const Shape wedge =
      combine(Shape::Kind::intersect, {block, tests::half_space({0, 2.5, 0}, {-0.6, 0.8, 0}),
                                       tests::half_space({0.7, 0, 0}, {0.8, 0.6, 0})});
  for (const int dimension : {2, 3}) {
    EXPECT_FALSE(has_corner(wedge, dimension)) << dimension;
    EXPECT_FALSE(has_corner(block, dimension)) << dimension;
    EXPECT_FALSE(has_corner(ring, dimension)) << dimension;
    EXPECT_FALSE(has_corner(ball({0.3, 0, 0}, 1), dimension)) << dimension;
  }
}

TEST(reentrant_corner, is_where_the_planes_of_both_faces_meet) {
  const double c = std::sqrt(0.75);
  const std::vector<Facet> facets = {{{-0.5, 0.1, 0}, {1, 0, 0}}, {{1, 0.5, 0}, {-0.5, -c, 0}}};
  const auto faces = faces_of_corner(facets);
  ASSERT_TRUE(faces.has_value());
  const Vector place = meeting_place(*faces);
  EXPECT_NEAR(place[0], -0.5, 1e-12);
  EXPECT_NEAR(place[1], 0.5 + 0.75 / c, 1e-12);
}

}  // namespace
}  // namespace pliant

#include "engine/point_based/cutting/crossing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pliant::point_based {
namespace {

TEST(crossing, is_where_the_bond_meets_the_piece) {
  const auto in_2d = crossing<2>({0, 0}, {1, 1}, {{{0, 0.5}, {1, 0.5}}});
  ASSERT_TRUE(in_2d);
  EXPECT_DOUBLE_EQ((*in_2d)[0], 0.5);
  const auto in_3d =
      crossing<3>({0.2, 0.2, -1}, {0.2, 0.2, 3}, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
  ASSERT_TRUE(in_3d);
  EXPECT_NEAR((*in_3d)[2], 0, 1e-15);
  EXPECT_FALSE(crossing<2>({0, 0}, {1, 0.4}, {{{0, 0.5}, {1, 0.5}}}));
  EXPECT_FALSE(crossing<2>({2, 0}, {2, 1}, {{{0, 0.5}, {1, 0.5}}}));
  EXPECT_FALSE(crossing<3>({0.8, 0.8, -1}, {0.8, 0.8, 1}, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}));
}

TEST(crossing, the_boundary_of_a_piece_belongs_to_it) {
  EXPECT_TRUE(crossing<2>({1, 0}, {1, 1}, {{{0, 0.5}, {1, 0.5}}}));
  EXPECT_TRUE(crossing<3>({0, 0, -1}, {0, 0, 1}, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}));
  EXPECT_TRUE(crossing<3>({0.5, 0.5, -1}, {0.5, 0.5, 1}, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}));
}

// Otherwise two blades that cut one plane in opposite directions would isolate the nodes on it.
TEST(crossing, a_node_on_a_piece_is_on_one_side_whichever_way_the_blade_went) {
  using Segment = std::array<MaterialPoint<2>, 2>;
  for (const Segment& along_x : {Segment{{{0, 0}, {1, 0}}}, Segment{{{1, 0}, {0, 0}}}}) {
    EXPECT_FALSE(crossing<2>({0.5, 0}, {0.5, 1}, along_x));
    EXPECT_TRUE(crossing<2>({0.5, 0}, {0.5, -1}, along_x));
    EXPECT_FALSE(crossing<2>({0.2, 0}, {0.5, 0}, along_x));
  }
  using Triangle = std::array<MaterialPoint<3>, 3>;
  const Triangle upward = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
                 downward = {{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}};
  for (const Triangle& triangle : {upward, downward}) {
    EXPECT_FALSE(crossing<3>({0.2, 0.2, 0}, {0.2, 0.2, 1}, triangle));
    EXPECT_TRUE(crossing<3>({0.2, 0.2, 0}, {0.2, 0.2, -1}, triangle));
  }
}

// A turned and shifted strip of triangles through the origin: every bond across it is found,
// including those through its vertices and edges.
TEST(crossing, no_bond_slips_through_between_the_triangles_of_a_strip) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  CutSurface<3> strip;
  const double c = std::cos(0.7), s = std::sin(0.7);
  const auto turned = [&](double x, double y, double z) {
    return MaterialPoint<3>{c * x - s * z, y, s * x + c * z};
  };
  for (int k = 0; k <= 6; ++k) {
    strip.add_station(
        {turned(k / 3. - 1, -1, 0), turned(k / 3. - 1, 0.1, 0), turned(k / 3. - 1, 1, 0)});
  }
  ASSERT_EQ(strip.pieces().size(), 24u);
  for (int trial = 0; trial < 3000; ++trial) {
    // A third of the bonds go through a vertex, another third through an edge.
    double x = 0.9 * uniform(random), y = 0.9 * uniform(random);
    if (trial % 3 != 2) x = std::round(3 * x) / 3;
    if (trial % 3 == 0) y = 0.1;
    const double dx = uniform(random), dy = uniform(random), dz = 0.1 + std::abs(uniform(random));
    const auto p = turned(x - dx, y - dy, -dz), q = turned(x + dx, y + dy, dz);
    bool is_found = false;
    for (std::size_t piece = 0; piece < strip.pieces().size(); ++piece) {
      is_found = is_found || crossing<3>(p, q, strip.corners(piece)).has_value();
    }
    EXPECT_TRUE(is_found) << trial;
  }
}

TEST(crossing, distances_to_pieces_are_those_to_their_nearest_points) {
  const std::array<MaterialPoint<3>, 3> triangle = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  EXPECT_DOUBLE_EQ(distance_to_piece<3>({0.2, 0.2, -2}, triangle).distance, 2);
  EXPECT_DOUBLE_EQ(distance_to_piece<3>({0.2, 0.2, -2}, triangle).across, -2);
  EXPECT_DOUBLE_EQ(distance_to_piece<3>({-3, 0.5, 4}, triangle).distance, 5);
  EXPECT_DOUBLE_EQ(distance_to_piece<3>({1, 1, 0}, triangle).distance, std::sqrt(0.5));
  EXPECT_DOUBLE_EQ(distance_to_piece<2>({4, 4}, {{{0, 0}, {1, 0}}}).distance, 5);
}

}  // namespace
}  // namespace pliant::point_based

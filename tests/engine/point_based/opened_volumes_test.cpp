#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "tests/engine/point_based/cut_block.hpp"
#include "tests/engine/point_based/enclosed_volumes.hpp"

// The volumes inside the surface of a body with cuts, compared with exact ones.
namespace pliant::test {
namespace {

void expect_volumes(const std::vector<double>& found, std::vector<double> expected, double bound) {
  std::sort(expected.begin(), expected.end());
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], bound) << i;
}

// The surface of a lattice is 1e-9 spacings outside its points.
constexpr double lattice_rounding = 6 * 0.125e-9;

template <int D>
void expect_halves() {
  for (const double x : {0.5, 0.53, 0.5 + 1e-7, 0.3125}) {  // 0.5: through points of the lattice
    CutBlock<D> block;
    sweep<D>(block.add_cut(), {x, -0.1, -0.1}, {x, 1.1, -0.1}, 77);
    block.surface();
    EXPECT_TRUE(is_closed<D>(block.vertices)) << x;
    expect_volumes(volumes_of<D>(block.vertices), {x, 1 - x}, lattice_rounding);
  }
}

TEST(opened_surface, has_the_volumes_of_the_parts_of_a_straight_cut) {
  expect_halves<2>();
  expect_halves<3>();
}

template <int D>
void expect_oblique_parts() {
  CutBlock<D> block;
  sweep<D>(block.add_cut(), {-0.1, 0.25, -0.1}, {1.1, 0.85, -0.1}, 60);
  block.surface();
  EXPECT_TRUE(is_closed<D>(block.vertices));
  expect_volumes(volumes_of<D>(block.vertices), {0.55, 0.45}, lattice_rounding);
}

TEST(opened_surface, has_the_volumes_of_the_parts_of_an_oblique_cut) {
  expect_oblique_parts<2>();
  expect_oblique_parts<3>();
  CutBlock<3> block;  // tilted towards x too: the plane x = 0.25 + 0.3 y + 0.2 z
  sweep<3>(block.add_cut(), {0.25 - 0.05, -0.1, -0.1}, {0.25 + 0.31, 1.1, -0.1}, 60,
           {0.24, 0, 1.2});
  block.surface();
  EXPECT_TRUE(is_closed<3>(block.vertices));
  expect_volumes(volumes_of<3>(block.vertices), {0.5, 0.5}, lattice_rounding);
}

// Lines between points on the edges of the lattice cut corners: in all by at most h^2/8 times the
// curvature.
template <int D>
void expect_curved_parts() {
  CutBlock<D> block;
  const double radius = 0.6;
  point_based::CutSurface<D>& cut = block.add_cut();
  for (int i = -5; i <= 205; ++i) {
    const double angle = i * std::numbers::pi / 400;
    cut.add_station(station<D>(radius * std::cos(angle), radius * std::sin(angle)));
  }
  block.surface();
  EXPECT_TRUE(is_closed<D>(block.vertices));
  const double inside = std::numbers::pi / 4 * radius * radius;
  const std::vector<double> found = volumes_of<D>(block.vertices);
  const double arc = std::numbers::pi / 2 * radius;
  expect_volumes(found, {inside, 1 - inside}, arc * 0.125 * 0.125 / (8 * radius));
  EXPECT_NEAR(std::accumulate(found.begin(), found.end(), 0.), 1, lattice_rounding);
}

TEST(opened_surface, has_the_volumes_of_the_parts_of_a_curved_cut) {
  expect_curved_parts<2>();
  expect_curved_parts<3>();
}

template <int D>
void expect_crossed_parts(double slope) {
  CutBlock<D> block;
  sweep<D>(block.add_cut(), {0.47, -0.1, -0.1}, {0.47, 1.1, -0.1}, 60);
  const double at_edge = 0.53 - 0.1 * slope;
  sweep<D>(block.add_cut(), {-0.1, at_edge, -0.1}, {1.1, at_edge + 1.2 * slope, -0.1}, 60);
  block.surface();
  EXPECT_TRUE(is_closed<D>(block.vertices));
  const double left = 0.47 * (0.53 + slope * 0.47 / 2);
  const double right = 0.53 * (0.53 + slope * (0.47 + 0.53 / 2));
  expect_volumes(volumes_of<D>(block.vertices), {left, 0.47 - left, right, 0.53 - right},
                 lattice_rounding);
}

TEST(opened_surface, has_the_volumes_of_the_parts_of_cuts_that_cross) {
  expect_crossed_parts<2>(0);
  expect_crossed_parts<2>(0.2);
  expect_crossed_parts<3>(0);
  expect_crossed_parts<3>(0.2);
}

// The second one goes through the opening of the first one.
template <int D>
void expect_coplanar() {
  CutBlock<D> block;
  sweep<D>(block.add_cut(), {0.5, -0.1, -0.1}, {0.5, 0.6, -0.1}, 33);
  sweep<D>(block.add_cut(), {0.5, 1.1, -0.1}, {0.5, -0.1, -0.1}, 50);
  block.surface();
  EXPECT_TRUE(is_closed<D>(block.vertices));
  expect_volumes(volumes_of<D>(block.vertices), {0.5, 0.5}, lattice_rounding);
}

TEST(opened_surface, has_the_volumes_of_the_parts_of_two_cuts_of_one_plane) {
  expect_coplanar<2>();
  expect_coplanar<3>();
}

// A blade of three points whose cut ends in the body on all sides leaves a pocket, with a surface
// separate from that of the block.
TEST(opened_surface, has_a_pocket_where_a_cut_ends_in_the_body_on_all_sides) {
  CutBlock<3> block;
  point_based::CutSurface<3>& cut = block.add_cut();
  for (int i = 0; i <= 40; ++i) {
    const double x = 0.2 + 0.6 * i / 40;
    cut.add_station({{x, 0.2, 0.47}, {x, 0.5, 0.47}, {x, 0.8, 0.47}});
  }
  block.move([](const Point<3>& x) { return Point<3>{0, 0, x[2] > 0.47 ? 0.1 : 0}; });
  block.surface();
  EXPECT_TRUE(is_closed<3>(block.vertices));
  const std::vector<double> volumes = volumes_of<3>(block.vertices);
  ASSERT_EQ(volumes.size(), 2u);
  EXPECT_NEAR(volumes[1], 1.1, 0.01);
  // The pocket is 0.1 high over the middle of the cut, and closes within 0.8 spacings of its rim.
  EXPECT_LT(volumes[0], -0.1 * 0.4 * 0.4);
  EXPECT_GT(volumes[0], -0.1 * 0.6 * 0.6);
}

}  // namespace
}  // namespace pliant::test

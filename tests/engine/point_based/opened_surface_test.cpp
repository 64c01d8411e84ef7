#include "engine/point_based/observe/opened_surface.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "tests/engine/point_based/cut_block.hpp"
#include "tests/engine/point_based/enclosed_volumes.hpp"

// The surface of a body with cuts moves with the nodes on the side of each face.
namespace pliant::test {
namespace {

template <int D>
void expect_affine() {
  CutBlock<D> block;
  sweep<D>(block.add_cut(), {0.47, -0.1, 0.4}, {0.47, 0.7, 0.4}, 60);
  sweep<D>(block.add_cut(), {-0.1, 0.33, -0.1}, {1.1, 0.53, -0.1}, 60);
  Eigen::Matrix<double, D, D> f;
  for (int i = 0; i < D * D; ++i) f(i / D, i % D) = 0.1 * std::sin(3. * i);
  const auto displacement = [&](const Point<D>& x) {
    Point<D> u;
    for (int a = 0; a < D; ++a) {
      u[a] = 0.3 + a;
      for (int b = 0; b < D; ++b) u[a] += f(a, b) * x[b];
    }
    return u;
  };
  block.move(displacement);
  const std::vector<point_based::SurfaceVertex<D>> vertices = block.surface().vertices;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const Point<D> expected = displacement(vertices[v].place);
    for (int a = 0; a < D; ++a) {
      ASSERT_NEAR(block.vertices.displacement[D * v + a], expected[a], 1e-12) << v;
    }
  }
}

TEST(opened_surface, follows_affine_deformations_exactly) {
  expect_affine<2>();
  expect_affine<3>();
}

/// A cut along y = 0.53 up to x = 0.6, whose upper side has moved up by 0.2 (0.6 - x).
template <int D>
void expect_open_lips() {
  CutBlock<D> block;
  sweep<D>(block.add_cut(), {-0.2, 0.53, -0.1}, {0.6, 0.53, -0.1}, 60);
  block.move([](const Point<D>& x) {
    Point<D> u = {};
    if (x[1] > 0.53) u[1] = 0.2 * std::max(0., 0.6 - x[0]);
    return u;
  });
  const std::vector<point_based::SurfaceVertex<D>> vertices = block.surface().vertices;
  EXPECT_TRUE(is_closed<D>(block.vertices));
  int upper = 0, lower = 0, at_front = 0;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (vertices[v].cuts.empty()) continue;
    const Point<D>& x = vertices[v].place;
    EXPECT_NEAR(x[1], 0.53, 1e-12);
    const double moved = block.vertices.displacement[D * v + 1];
    if (std::abs(x[0] - 0.6) < 1e-6) {
      // All nodes near the front contribute: those that have not moved, and the ends of the wedge.
      EXPECT_NEAR(moved, 0, 0.2 * 0.125 / 2);
      ++at_front;
    } else if (x[0] < 0.35) {  // all nodes involved are on the straight part
      const bool is_above = moved > 0.1 * (0.6 - x[0]);
      EXPECT_NEAR(moved, is_above ? 0.2 * (0.6 - x[0]) : 0, 1e-12) << x[0];
      ++(is_above ? upper : lower);
    } else {
      EXPECT_LT(moved, 0.2 * (0.6 - x[0]) + 0.02) << x[0];
      EXPECT_GT(moved, -0.02) << x[0];
    }
  }
  EXPECT_EQ(upper, lower);
  EXPECT_GT(upper, D == 2 ? 5 : 50);
  EXPECT_GT(at_front, 0);
}

TEST(opened_surface, opens_by_what_the_sides_have_moved_apart_and_closes_at_the_front) {
  expect_open_lips<2>();
  expect_open_lips<3>();
}

TEST(opened_surface, does_not_depend_on_when_it_has_followed_a_cut) {
  CutBlock<3> block;
  point_based::OpenedSurface<3> often(
      block.body(), 0.125, point_based::inside_of<3>(block.body().source->geometry, 1e-7));
  point_based::CutSurface<3>& cut = block.add_cut();
  for (int i = 0; i <= 40; ++i) {
    cut.add_station(station<3>(-0.1 + 0.02 * i, 0.4 + 0.005 * i));
    often.follow(block.cuts);
  }
  block.move([](const Point<3>& x) { return Point<3>{0, std::sin(3 * x[0]), x[1] * x[2]}; });
  block.surface();
  point_based::SurfaceVertices vertices;
  often.add(block.body(), 7, vertices);
  EXPECT_EQ(vertices.position, block.vertices.position);
  EXPECT_EQ(vertices.vertex, block.vertices.vertex);
}

TEST(opened_surface, names_the_body_of_each_vertex) {
  CutBlock<2> block;
  sweep<2>(block.add_cut(), {-0.2, 0.53, 0}, {0.6, 0.53, 0}, 5);
  block.surface();
  EXPECT_EQ(3 * block.vertices.owner.size(), block.vertices.position.size());
  EXPECT_TRUE(std::all_of(block.vertices.owner.begin(), block.vertices.owner.end(),
                          [](std::int32_t owner) { return owner == 7; }));
}

TEST(opened_surface, is_that_of_frames_once_a_blade_has_cut) {
  const std::string blade = R"toml([[cut]]
name = "blade"
from = [-0.2, 0.53]
path = ["6e8*t", 0]
end = 2e-9
)toml";
  PointSolver<2> solver(tests::read_text(free_points(2) + blade, {"time.step=1e-9"}),
                        {1, kernels::widest_supported()});
  for (int step = 0; step < 4; ++step) solver.step(HUGE_VAL);
  // The outline of the block has 32 pieces; the cut crosses at least eight, each with two faces.
  EXPECT_GE(solver.frame({false, true}).surface->vertex.size() / 2, 32 + 2 * 8);
}

// A held block is stretched along x. By the gradients of single nodes, vertices of held nodes would
// move too.
TEST(opened_surface, is_that_of_frames_before_a_blade_cuts_too) {
  const std::string held_and_cut_late = R"toml([[boundary]]
name = "clamp"
kind = "fixed"
geometry = { shape = "half_space", point = [0.25, 0], normal = [1, 0] }
[[cut]]
name = "blade"
from = [-0.2, 0.53]
path = ["t - 9", 0]
start = 9
end = 10
)toml";
  PointSolver<2> solver(tests::read_text("gravity = [5, 0]\n" + free_points(2) + held_and_cut_late),
                        {1, kernels::widest_supported()});
  advance_until(solver, 0.3);
  const auto surface = *solver.frame({false, true}).surface;
  const auto& moved = std::get<std::vector<double>>(surface.fields[1].values);
  double farthest = 0;
  for (std::size_t v = 0; v < surface.position.size() / 3; ++v) {
    const double u = moved[2 * v];
    const double start = surface.position[3 * v] - u;
    farthest = std::max(farthest, u);
    if (start < 1e-9) {
      EXPECT_EQ(u, 0);
    }
  }
  EXPECT_GT(farthest, 1e-3);
}

}  // namespace
}  // namespace pliant::test

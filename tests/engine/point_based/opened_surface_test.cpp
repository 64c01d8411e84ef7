#include "engine/point_based/observe/opened_surface.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "engine/point_based/surface.hpp"
#include "tests/engine/point_based/blocks.hpp"

// The surface of a body with cuts, against volumes and distances that geometry gives.
namespace pliant::point_based {
namespace {

using test::PointSolver;

template <int D>
PointSolver<D> solver_of_opened(const std::string& text) {
  return PointSolver<D>(tests::read_text(text), {1, kernels::widest_supported()});
}

/// A cube [0, 1]^D with a cut body for its surfaces, and cuts that a test has made.
template <int D>
struct CutBlock {
  PointSolver<D> solver = solver_of_opened<D>(
      test::free_points(D) +
      (D == 2 ? "[[cut]]\nname = \"none\"\nfrom = [-1, -1]\npath = [0, 0]\nend = 1e-9\n"
              : "[[cut]]\nname = \"none\"\nfrom = [-1, -1, 0]\nto = [-1, -1, 1]\n"
                "path = [0, 0, 0]\nend = 1e-9\n"));
  std::vector<CutSurface<D>> cuts;
  SurfaceVertices vertices;

  Body<double, D>& body() { return solver.state().bodies[0]; }

  CutSurface<D>& add_cut() { return cuts.emplace_back(); }

  template <class F>
  void move(F&& displacement) {
    body().for_each_node([&](std::int64_t slot) {
      const Point<D> u = displacement(body().start[slot]);
      for (int a = 0; a < D; ++a) body().displacement[a][slot] = u[a];
    });
  }

  /// Fills `vertices`, and returns where they come from.
  DividedSurface<D> surface() {
    OpenedSurface<D> opened(body(), 0.125, inside_of<D>(body().source->geometry, 1e-7));
    opened.follow(cuts);
    vertices = {};
    opened.add(body(), 7, vertices);
    return opened.undeformed();
  }
};

/// The blade is a point (2D) or the line from z = `bottom` to z = 1.1 (3D), or as long as `tilt`
/// inclines it.
template <int D>
std::vector<Point<D>> station(double x, double y, double bottom = -0.1,
                              const Point<3>& tilt = {0, 0, 1.2}) {
  if constexpr (D == 2) {
    return {{x, y}};
  } else {
    return {{x, y, bottom}, {x + tilt[0], y + tilt[1], bottom + tilt[2]}};
  }
}

template <int D>
void sweep(CutSurface<D>& cut, const Point<3>& from, const Point<3>& to, int stations,
           const Point<3>& tilt = {0, 0, 1.2}) {
  for (int i = 0; i <= stations; ++i) {
    const double s = static_cast<double>(i) / stations;
    cut.add_station(station<D>(from[0] + s * (to[0] - from[0]), from[1] + s * (to[1] - from[1]),
                               from[2] + s * (to[2] - from[2]), tilt));
  }
}

/// Volume inside each connected part of a closed surface, ascending; areas in 2D.
template <int D>
std::vector<double> volumes_of(const SurfaceVertices& vertices) {
  std::vector<std::int64_t> root(vertices.owner.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](std::int64_t v) {
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  const std::size_t pieces = vertices.vertex.size() / D;
  for (std::size_t p = 0; p < pieces; ++p) {
    for (int k = 1; k < D; ++k) {
      root[find(vertices.vertex[D * p + k])] = find(vertices.vertex[D * p]);
    }
  }
  std::map<std::int64_t, double> volume;
  for (std::size_t p = 0; p < pieces; ++p) {
    Eigen::Matrix<double, D, D> corners;
    for (int k = 0; k < D; ++k) {
      for (int a = 0; a < D; ++a) {
        corners(a, k) = vertices.position[3 * vertices.vertex[D * p + k] + a] - 0.5;
      }
    }
    volume[find(vertices.vertex[D * p])] += corners.determinant() / (D == 2 ? 2 : 6);
  }
  std::vector<double> volumes;
  for (const auto& [part, of_part] : volume) volumes.push_back(of_part);
  std::sort(volumes.begin(), volumes.end());
  return volumes;
}

/// Whether each ridge of the surface belongs to as many pieces in one direction as in the other.
template <int D>
bool is_closed(const SurfaceVertices& vertices) {
  std::map<std::pair<std::int64_t, std::int64_t>, int> balance;
  for (std::size_t p = 0; p < vertices.vertex.size() / D; ++p) {
    for (int k = 0; k < D; ++k) {
      const std::int64_t a = vertices.vertex[D * p + k];
      const std::int64_t b = D == 2 ? -1 : vertices.vertex[D * p + (k + 1) % D];
      balance[std::minmax(a, b)] += (D == 2 ? k == 0 : a < b) ? 1 : -1;
    }
  }
  return std::all_of(balance.begin(), balance.end(),
                     [](const auto& ridge) { return ridge.second == 0; });
}

void expect_volumes(const std::vector<double>& found, std::vector<double> expected, double bound) {
  std::sort(expected.begin(), expected.end());
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], bound) << i;
}

// The surface of a lattice lies 1e-9 spacings outside its points.
constexpr double rounding = 6 * 0.125e-9;

template <int D>
void expect_halves() {
  for (const double x : {0.5, 0.53, 0.5 + 1e-7, 0.3125}) {  // 0.5: through points of the lattice
    CutBlock<D> block;
    sweep<D>(block.add_cut(), {x, -0.1, -0.1}, {x, 1.1, -0.1}, 77);
    block.surface();
    EXPECT_TRUE(is_closed<D>(block.vertices)) << x;
    expect_volumes(volumes_of<D>(block.vertices), {x, 1 - x}, rounding);
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
  expect_volumes(volumes_of<D>(block.vertices), {0.55, 0.45}, rounding);
}

TEST(opened_surface, has_the_volumes_of_the_parts_of_an_oblique_cut) {
  expect_oblique_parts<2>();
  expect_oblique_parts<3>();
  CutBlock<3> block;  // tilted towards x too: the plane x = 0.25 + 0.3 y + 0.2 z
  sweep<3>(block.add_cut(), {0.25 - 0.05, -0.1, -0.1}, {0.25 + 0.31, 1.1, -0.1}, 60,
           {0.24, 0, 1.2});
  block.surface();
  EXPECT_TRUE(is_closed<3>(block.vertices));
  expect_volumes(volumes_of<3>(block.vertices), {0.5, 0.5}, rounding);
}

// The lines between points on the edges of the lattice cut corners: by h^2/8 times the curvature at
// most, in all.
template <int D>
void expect_curved_parts() {
  CutBlock<D> block;
  const double radius = 0.6;
  CutSurface<D>& cut = block.add_cut();
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
  EXPECT_NEAR(std::accumulate(found.begin(), found.end(), 0.), 1, rounding);
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
  expect_volumes(volumes_of<D>(block.vertices), {left, 0.47 - left, right, 0.53 - right}, rounding);
}

TEST(opened_surface, has_the_volumes_of_the_parts_of_cuts_that_cross) {
  expect_crossed_parts<2>(0);
  expect_crossed_parts<2>(0.2);
  expect_crossed_parts<3>(0);
  expect_crossed_parts<3>(0.2);
}

// The second one goes through what the first one has opened.
template <int D>
void expect_coplanar() {
  CutBlock<D> block;
  sweep<D>(block.add_cut(), {0.5, -0.1, -0.1}, {0.5, 0.6, -0.1}, 33);
  sweep<D>(block.add_cut(), {0.5, 1.1, -0.1}, {0.5, -0.1, -0.1}, 50);
  block.surface();
  EXPECT_TRUE(is_closed<D>(block.vertices));
  expect_volumes(volumes_of<D>(block.vertices), {0.5, 0.5}, rounding);
}

TEST(opened_surface, has_the_volumes_of_the_parts_of_two_cuts_of_one_plane) {
  expect_coplanar<2>();
  expect_coplanar<3>();
}

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
  const std::vector<SurfaceVertex<D>> vertices = block.surface().vertices;
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
  const std::vector<SurfaceVertex<D>> vertices = block.surface().vertices;
  EXPECT_TRUE(is_closed<D>(block.vertices));
  int upper = 0, lower = 0, at_front = 0;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (vertices[v].cuts.empty()) continue;
    const Point<D>& x = vertices[v].place;
    EXPECT_NEAR(x[1], 0.53, 1e-12);
    const double moved = block.vertices.displacement[D * v + 1];
    if (std::abs(x[0] - 0.6) < 1e-6) {
      // All nodes near the front count: those that have not moved, and the ends of the wedge.
      EXPECT_NEAR(moved, 0, 0.2 * 0.125 / 2);
      ++at_front;
    } else if (x[0] < 0.35) {  // all nodes that count are on the straight part
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

// A blade of three points that ends in the body on all sides leaves a pocket, whose surface is
// apart from that of the block.
TEST(opened_surface, has_a_pocket_where_a_cut_ends_in_the_body_on_all_sides) {
  CutBlock<3> block;
  CutSurface<3>& cut = block.add_cut();
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
  // It is 0.1 high over the middle of the cut, and closes within 0.8 spacings of its rim.
  EXPECT_LT(volumes[0], -0.1 * 0.4 * 0.4);
  EXPECT_GT(volumes[0], -0.1 * 0.6 * 0.6);
}

TEST(opened_surface, does_not_depend_on_when_it_has_followed_a_cut) {
  CutBlock<3> block;
  OpenedSurface<3> often(block.body(), 0.125, inside_of<3>(block.body().source->geometry, 1e-7));
  CutSurface<3>& cut = block.add_cut();
  for (int i = 0; i <= 40; ++i) {
    cut.add_station(station<3>(-0.1 + 0.02 * i, 0.4 + 0.005 * i));
    often.follow(block.cuts);
  }
  block.move([](const Point<3>& x) { return Point<3>{0, std::sin(3 * x[0]), x[1] * x[2]}; });
  block.surface();
  SurfaceVertices vertices;
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
  PointSolver<2> solver(tests::read_text(test::free_points(2) + blade, {"time.step=1e-9"}),
                        {1, kernels::widest_supported()});
  for (int step = 0; step < 4; ++step) solver.step(HUGE_VAL);
  // The outline of the block has 32 pieces; the cut crosses it in eight or more, each with two
  // faces.
  EXPECT_GE(solver.frame({false, true}).surface->vertex.size() / 2, 32 + 2 * 8);
}

}  // namespace
}  // namespace pliant::point_based

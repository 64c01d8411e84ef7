#include "engine/remeshed/level_set/projections.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/remeshed/level_set/node_values.hpp"

namespace pliant::test {
namespace {

using remeshed::Projections;

constexpr int farthest_move = 3, iterations = 12;

/// The surface of a disc or a ball, in cells.
template <int D>
struct Round {
  Point<D> centre;
  double radius;

  double distance(const Point<D>& x) const {
    double square = 0;
    for (int a = 0; a < D; ++a) square += std::pow(x[a] - centre[a], 2);
    return std::sqrt(square) - radius;
  }
  Point<D> closest(const Point<D>& x) const {
    Point<D> at;
    for (int a = 0; a < D; ++a) {
      at[a] = centre[a] + (x[a] - centre[a]) * radius / (distance(x) + radius);
    }
    return at;
  }
};

/// Projects all nodes within 1.8 cells of the zero set of `values`.
template <int D, class F>
Projections<double, D> projected(const NodeValues<D>& nodes, F&& distance) {
  Projections<double, D> points;
  for (const Block<D>& block : nodes.layout.blocks()) {
    nodes.layout.for_each_slot(block, [&](std::int64_t slot, const Cell<D>& cell) {
      if (std::abs(distance(point_of<D>(cell))) < 1.8) points.add(slot, cell, point_of<D>(cell));
    });
  }
  points.run(nodes.lattice, nodes.layout, nodes.values.data(), farthest_move, iterations,
             kernels::RemeshedTable<double, D>::of(kernels::Isa::sse2));
  return points;
}

template <class Space>
struct ProjectionsOnto : testing::Test {};
TYPED_TEST_SUITE(ProjectionsOnto, Dimensions);

// Cubic interpolation is exact for linear values, whatever their slope.
TYPED_TEST(ProjectionsOnto, planes_are_exact) {
  constexpr int D = TypeParam::dimension;
  Point<D> normal;
  for (int a = 0; a < D; ++a) normal[a] = D == 2 ? (a == 0 ? 0.6 : 0.8) : std::sqrt(1. / 3);
  const auto distance = [&](const Point<D>& x) {
    double sum = -11.3;
    for (int a = 0; a < D; ++a) sum += normal[a] * x[a];
    return sum;
  };
  // Away from the rim of the block, where the interpolation would need nodes outside.
  const NodeValues<D> nodes(diagonal<D>(23), {},
                            [&](const Point<D>& x) { return 0.3 * distance(x); });
  const auto points = projected<D>(nodes, [&](const Point<D>& x) {
    const auto [least, most] = std::minmax_element(x.begin(), x.end());
    return *least < 4 || *most > 19 ? 1e9 : distance(x);
  });
  ASSERT_GT(points.size(), 20u);
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_TRUE(points.has_converged(i)) << i;
    const double from_node = distance(points.node(i));
    for (int a = 0; a < D; ++a) {
      EXPECT_NEAR(points.point(i)[a], points.node(i)[a] - from_node * normal[a], 1e-9) << i;
    }
  }
}

TYPED_TEST(ProjectionsOnto, round_surfaces_are_of_the_order_of_cubic_interpolation) {
  constexpr int D = TypeParam::dimension;
  Round<D> surface{{}, 7.3};
  surface.centre.fill(11.4);
  surface.centre[0] += 0.2;
  const auto distance = [&](const Point<D>& x) { return surface.distance(x); };
  const NodeValues<D> nodes(diagonal<D>(23), {}, distance);
  const auto points = projected<D>(nodes, distance);
  ASSERT_GT(points.size(), 100u);
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_TRUE(points.has_converged(i)) << i;
    // 3/128 of the fourth derivative of the distance, up to 3/R^3 in each direction.
    EXPECT_NEAR(surface.distance(points.point(i)), 0, D * 9. / 128 / std::pow(7.3 - 2.8, 3)) << i;
    // Along the surface the error is that of the gradient times the distance, up to 1.8.
    const Point<D> closest = surface.closest(points.node(i));
    for (int a = 0; a < D; ++a) EXPECT_NEAR(points.point(i)[a], closest[a], 0.005) << i;
  }
}

TYPED_TEST(ProjectionsOnto, nodes_without_a_surface_do_not_converge) {
  constexpr int D = TypeParam::dimension;
  const NodeValues<D> nodes(diagonal<D>(11), {}, [](const Point<D>& x) { return 5 + 0.1 * x[0]; });
  Projections<double, D> points;
  const Cell<D> cell = diagonal<D>(5);
  points.add(nodes.layout.slot(cell), cell, point_of<D>(cell));
  points.run(nodes.lattice, nodes.layout, nodes.values.data(), farthest_move, iterations,
             kernels::RemeshedTable<double, D>::of(kernels::Isa::sse2));
  EXPECT_FALSE(points.has_converged(0));
}

TYPED_TEST(ProjectionsOnto, surfaces_beyond_a_period_are_found) {
  constexpr int D = TypeParam::dimension;
  Cell<D> period = {};
  period[0] = 16;
  // Two planes across x, at 0.3 and at 8.3.
  const double k = 2 * std::acos(-1.0) / 16;
  const NodeValues<D> nodes(diagonal<D>(15), period,
                            [&](const Point<D>& x) { return std::sin(k * (x[0] - 0.3)) / k; });
  Projections<double, D> points;
  Cell<D> cell = diagonal<D>(7);
  cell[0] = 15;
  points.add(nodes.layout.slot(cell), cell, point_of<D>(cell));
  points.run(nodes.lattice, nodes.layout, nodes.values.data(), farthest_move, iterations,
             kernels::RemeshedTable<double, D>::of(kernels::Isa::sse2));
  ASSERT_TRUE(points.has_converged(0));
  // 3/128 (k h)^4/k
  EXPECT_NEAR(points.point(0)[0], 16.3, 3. / 128 * k * k * k);
}

}  // namespace
}  // namespace pliant::test

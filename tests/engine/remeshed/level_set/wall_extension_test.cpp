#include "engine/remeshed/level_set/wall_extension.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/geometry/padded.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "tests/engine/remeshed/level_set/node_values.hpp"

namespace pliant::test {
namespace {

using remeshed::WallExtension;

constexpr double spacing = 0.5, far = 3.25;
constexpr int upper = 23;

/// A wall or a contact wall with the surface y = `height` [m] and the solid below.
BoundaryCase floor_at(double height, BoundaryCase::Kind kind) {
  BoundaryCase boundary;
  boundary.kind = kind;
  boundary.geometry.kind = Shape::Kind::half_space;
  boundary.geometry.point = {0, height, 0};
  boundary.geometry.normal = {0, 1, 0};
  return boundary;
}

Shape flat_surface() {
  Shape surface;
  surface.kind = Shape::Kind::half_space;
  surface.normal = {0.8, 0.6, 0};
  return surface;
}

/// phi as a function of the place of a node [m], and its extension behind the wall; the initial
/// surface is flat.
template <int D>
struct Extension {
  template <class Phi>
  Extension(const BoundaryCase& boundary, Phi&& of)
      : phi(
            diagonal<D>(upper), {},
            [&](const Point<D>& x) {
              Point<D> at;
              for (int a = 0; a < D; ++a) at[a] = (x[a] + 0.5) * spacing;
              return of(at);
            },
            spacing),
        valid(phi.layout.slots(), 1),
        extended(phi.layout.slots()),
        boundaries(std::vector<BoundaryCase>{boundary}) {}

  /// Calls f(place, value) for every node.
  template <class F>
  void for_each_extended(F&& f) {
    const WallExtension<double, D> extension(phi.lattice, phi.layout, initial, phi.values.data(),
                                             valid.data(), far);
    for (const Block<D>& block : phi.layout.blocks()) {
      extension.extend(block, boundaries, extended.data());
    }
    for_each_cell<D>({}, diagonal<D>(upper), [&](const Cell<D>& cell) {
      f(phi.lattice.node(cell), extended[phi.layout.slot(cell)]);
    });
  }

  NodeValues<D> phi;
  std::vector<double> valid, extended;
  Boundaries<D> boundaries;
  Shape initial = flat_surface();
};

template <class Space>
struct BehindWalls : testing::Test {};
TYPED_TEST_SUITE(BehindWalls, Dimensions);

// A surface that meets the wall at an angle, phi = n.x - c: remeshing has left no particles behind
// the wall.
TYPED_TEST(BehindWalls, plane_surfaces_run_on_exactly) {
  constexpr int D = TypeParam::dimension;
  const double height = 3.1;
  const auto plane = [](const Point<D>& x) { return 0.8 * x[0] + 0.6 * x[1] - 6.2; };
  Extension<D> nodes(floor_at(height, BoundaryCase::Kind::fixed),
                     [&](const Point<D>& x) { return x[1] < height ? 1e3 : plane(x); });
  int behind = 0;
  nodes.for_each_extended([&](const Point<D>& x, double value) {
    if (x[1] >= height) {
      EXPECT_EQ(value, plane(x));
      return;
    }
    // Cubic interpolation needs one more node on each side.
    if (x[D - 1] > upper * spacing) return;
    // The line through points 1.5 h and 2.5 h in front of the wall, where the surface is near.
    const double in_front = plane(x) + 0.6 * (height + 1.5 * spacing - x[1]);
    if (std::abs(in_front) > 3 * spacing) return;
    ++behind;
    EXPECT_NEAR(value, plane(x), 1e-12);
  });
  EXPECT_GT(behind, 20);
}

// A disc or ball of 7 m, cut by the wall 1 m above its centre.
TYPED_TEST(BehindWalls, surfaces_keep_the_curvature_that_they_began_with) {
  constexpr int D = TypeParam::dimension;
  const double height = 3.1, radius = 7;
  const Point<D> centre = [] {
    Point<D> c;
    c.fill(0.5);
    c[1] = 2.1;
    return c;
  }();
  const auto ball = [&](const Point<D>& x) {
    double square = 0;
    for (int a = 0; a < D; ++a) square += std::pow(x[a] - centre[a], 2);
    return std::sqrt(square) - radius;
  };
  Extension<D> nodes(floor_at(height, BoundaryCase::Kind::fixed),
                     [&](const Point<D>& x) { return x[1] < height ? 1e3 : ball(x); });
  nodes.initial.kind = Shape::Kind::ball;
  nodes.initial.centre = padded<D>(centre);
  nodes.initial.radius = radius;
  int behind = 0;
  nodes.for_each_extended([&](const Point<D>& x, double value) {
    if (x[1] >= height || std::max(x[0], x[D - 1]) > upper * spacing) return;
    if (std::abs(ball(x)) > 1.5 * spacing || height - x[1] > 4 * spacing) return;
    ++behind;
    EXPECT_NEAR(value, ball(x), 0.1 * spacing);
  });
  EXPECT_GT(behind, 10);
}

// (RP.100): a surface that comes down to the wall, and has 1.5 h above it phi = -1.3 h.
TYPED_TEST(BehindWalls, surfaces_that_faced_the_wall_from_the_start_end_where_they_touch_it) {
  constexpr int D = TypeParam::dimension;
  const double height = 3.1, slope = 0.9;
  const auto plane = [&](const Point<D>& x) { return 0.05 * spacing - slope * (x[1] - height); };
  for (const bool faced : {false, true}) {
    Extension<D> nodes(floor_at(height, BoundaryCase::Kind::fixed), plane);
    nodes.initial.normal = faced ? Vector{0, -1, 0} : Vector{1, 0, 0};
    nodes.for_each_extended([&](const Point<D>& x, double value) {
      if (x[1] >= height || std::max(x[0], x[D - 1]) > upper * spacing) return;
      const double touching = (0.05 - slope * 1.5 + 0.7 * 1.5) * spacing;
      // The wall holds what it held at the start.
      const double at_most = signed_distance(nodes.initial, padded<D>(x), D);
      EXPECT_NEAR(value, faced ? touching : std::min(plane(x), at_most), 1e-12);
    });
  }
}

// (RP.100): behind the wall the surface follows its normal, and the wall holds a part of a spacing
// beyond the rim.
TYPED_TEST(BehindWalls, surfaces_that_lean_over_a_wall_stay_at_the_rim) {
  constexpr int D = TypeParam::dimension;
  const double height = 3.1;
  const auto plane = [](const Point<D>& x) { return 0.8 * x[0] - 0.6 * x[1] - 2.6; };
  Extension<D> nodes(floor_at(height, BoundaryCase::Kind::fixed),
                     [&](const Point<D>& x) { return x[1] < height ? 1e3 : plane(x); });
  nodes.initial.normal = {0.8, -0.6, 0};
  nodes.initial.point = {2.6 / 0.8, 0, 0};
  int behind = 0;
  nodes.for_each_extended([&](Point<D> x, double value) {
    if (x[1] >= height || std::max(x[0], x[D - 1]) > upper * spacing) return;
    x[1] = height;
    if (std::abs(plane(x)) > spacing) return;
    ++behind;
    EXPECT_NEAR(value, plane(x) - 0.35 * 0.8 * spacing, 1e-12);
  });
  EXPECT_GT(behind, 10);
}

// (RP.106): remeshing has left no particles behind the wall.
TYPED_TEST(BehindWalls, surfaces_are_mirrored_at_frictionless_walls) {
  constexpr int D = TypeParam::dimension;
  const double height = 3.1, deepest = 4.5 * spacing;
  const auto plane = [](const Point<D>& x) { return 0.8 * x[0] + 0.6 * x[1] - 6.2; };
  Extension<D> nodes(floor_at(height, BoundaryCase::Kind::slip_wall), [&](const Point<D>& x) {
    return x[1] < height - 2 * spacing ? 1e3 : plane({x[0], std::max(x[1], 2 * height - x[1])});
  });
  int behind = 0;
  nodes.for_each_extended([&](Point<D> x, double value) {
    if (x[1] >= height || height - x[1] > deepest) return;
    x[1] = 2 * height - x[1];
    // Next to the wall is a parabola; beside the last nodes, interpolation reads others.
    if (x[1] - height < 1.5 * spacing || std::max(x[0], x[D - 1]) > upper * spacing) return;
    ++behind;
    EXPECT_NEAR(value, plane(x), 1e-12);
  });
  EXPECT_GT(behind, 20);
}

// (RP.54)
TYPED_TEST(BehindWalls, bodies_end_at_contact_walls) {
  constexpr int D = TypeParam::dimension;
  const double height = 3.1;
  const auto plane = [](const Point<D>& x) { return 0.8 * x[0] + 0.6 * x[1] - 6.2; };
  Extension<D> nodes(floor_at(height, BoundaryCase::Kind::contact_wall), plane);
  nodes.for_each_extended([&](const Point<D>& x, double value) {
    EXPECT_NEAR(value, std::max(plane(x), height - x[1]), 1e-12);
  });
}

TYPED_TEST(BehindWalls, nodes_that_remeshing_left_empty_are_far_outside) {
  constexpr int D = TypeParam::dimension;
  Extension<D> nodes(floor_at(-100, BoundaryCase::Kind::fixed), [](const Point<D>&) { return -1; });
  const std::int64_t empty = nodes.phi.layout.slot(diagonal<D>(7));
  nodes.valid[empty] = 0;
  nodes.for_each_extended([](const Point<D>&, double) {});
  EXPECT_EQ(nodes.extended[empty], far);
  EXPECT_EQ(nodes.extended[nodes.phi.layout.slot(diagonal<D>(8))], -1);
}

}  // namespace
}  // namespace pliant::test

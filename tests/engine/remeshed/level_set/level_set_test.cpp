#include "engine/remeshed/level_set/level_set.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/remeshed/level_set/node_values.hpp"

namespace pliant::test {
namespace {

using remeshed::first_order_passes;
using remeshed::Reinitialisation;

/// All passes over values on nodes, without walls. Distances are in cells, as the spacing is 1.
template <int D>
struct Passes {
  using LevelSet = remeshed::LevelSet<double, D>;

  template <class F>
  Passes(int upper, F&& f, bool reinitialise, Reinitialisation by = Reinitialisation::closest_point)
      : nodes(diagonal<D>(upper), {}, f),
        before(nodes.values),
        extended(nodes.values.size()),
        valid(nodes.values.size(), 0),
        level_set(by) {
    std::array<double*, D> foot_of;
    for (int a = 0; a < D; ++a) {
      foot[a].resize(nodes.values.size());
      foot_of[a] = foot[a].data();
    }
    for_each_cell<D>({}, diagonal<D>(upper),
                     [&](const Cell<D>& cell) { valid[nodes.layout.slot(cell)] = 1; });
    level_set.prepare(nodes.lattice, nodes.layout, nodes.values.data());
    level_set.use(extended.data(), foot_of);
    const auto& table = kernels::RemeshedTable<double, D>::of(kernels::Isa::sse2);
    const Boundaries<D> none(std::vector<BoundaryCase>{});
    each([&](const Block<D>& b) { level_set.extend_through_walls(b, none, {}, valid.data()); });
    for (int pass = 0; reinitialise && level_set.is_first_order() && pass < first_order_passes;
         ++pass) {
      each([&](const Block<D>& b) { level_set.advance(b, pass); });
    }
    each([&](const Block<D>& b) { level_set.find_closest_points(b, table); });
    if (reinitialise) each([&](const Block<D>& b) { level_set.take_distances(b); });
    for (int layer = 2; layer <= LevelSet::layers; ++layer) {
      each([&](const Block<D>& b) { level_set.add_layer(b, layer, table); });
    }
    each([&](const Block<D>& b) { level_set.finish(b); });
  }

  template <class F>
  void each(F&& pass) {
    for (const Block<D>& block : nodes.layout.blocks()) pass(block);
  }

  /// Calls f(node in cells, slot) for nodes at least `margin` cells from the rim.
  template <class F>
  void inside(int upper, int margin, F&& f) const {
    for_each_cell<D>(diagonal<D>(margin), diagonal<D>(upper - margin),
                     [&](const Cell<D>& cell) { f(point_of<D>(cell), nodes.layout.slot(cell)); });
  }

  NodeValues<D> nodes;
  std::vector<double> before, extended, valid;
  std::array<std::vector<double>, D> foot;
  LevelSet level_set;
};

/// A tilted plane's signed distance, in cells.
template <int D>
double plane(const Point<D>& x) {
  return 0.6 * x[0] + 0.8 * x[1] - 18.3;
}

/// The signed distance from a disc or a ball.
template <int D>
double round_body(const Point<D>& x) {
  double square = 0;
  for (int a = 0; a < D; ++a) square += std::pow(x[a] - 15.4 - 0.1 * a, 2);
  return std::sqrt(square) - 8.3;
}

template <class Space>
struct LevelSets : testing::Test {};
TYPED_TEST_SUITE(LevelSets, Dimensions);

// Four fifths of a distance: the right surface with the wrong slope.
TYPED_TEST(LevelSets, of_planes_become_exact_distances_in_six_layers) {
  constexpr int D = TypeParam::dimension;
  constexpr int upper = 27;
  const Passes<D> passes(
      upper, [](const Point<D>& x) { return 0.8 * plane<D>(x); }, true);
  int near = 0, layered = 0;
  passes.inside(upper, 9, [&](const Point<D>& x, std::int64_t slot) {
    const double exact = plane<D>(x), phi = passes.nodes.values[slot];
    if (std::abs(exact) < 2.5) {
      ++near;
      EXPECT_NEAR(phi, exact, 1e-6);
    } else if (std::abs(exact) < 5) {
      ++layered;
      EXPECT_NEAR(phi, exact, 1e-6);
    }
    Point<D> offset;
    if (std::abs(exact) < 5) {
      ASSERT_TRUE(passes.level_set.closest_point(slot, offset));
      EXPECT_NEAR(offset[0], -0.6 * exact, 1e-6);
      EXPECT_NEAR(offset[1], -0.8 * exact, 1e-6);
      EXPECT_NEAR(passes.level_set.surface_distance(slot), exact, 1e-6);
    }
  });
  EXPECT_GT(near, 10);
  EXPECT_GT(layered, 10);
  passes.inside(upper, 0, [&](const Point<D>& x, std::int64_t slot) {
    if (std::abs(plane<D>(x)) < 10) return;
    EXPECT_EQ(passes.nodes.values[slot], plane<D>(x) < 0 ? -6.5 : 6.5);
  });
}

// What a receding body leaves behind: phi of a node near a surface, but no surface there.
TYPED_TEST(LevelSets, take_no_node_for_near_where_phi_never_changes_its_sign) {
  constexpr int D = TypeParam::dimension;
  constexpr int upper = 27;
  const Passes<D> passes(
      upper,
      [](const Point<D>& x) { return plane<D>(x) > 9 ? 1 + 0.1 * std::sin(x[0]) : plane<D>(x); },
      true);
  int stale = 0;
  passes.inside(upper, 0, [&](const Point<D>& x, std::int64_t slot) {
    if (plane<D>(x) < 9) return;
    ++stale;
    EXPECT_EQ(passes.nodes.values[slot], 6.5);
  });
  EXPECT_GT(stale, 10);
}

TYPED_TEST(LevelSets, keep_phi_near_the_surface_unless_reinitialised) {
  constexpr int D = TypeParam::dimension;
  constexpr int upper = 27;
  const Passes<D> passes(
      upper, [](const Point<D>& x) { return 0.8 * plane<D>(x); }, false);
  passes.inside(upper, 9, [&](const Point<D>& x, std::int64_t slot) {
    if (std::abs(0.8 * plane<D>(x)) > 1.8) return;
    EXPECT_EQ(passes.nodes.values[slot], passes.before[slot]);
    // The closest point is found nevertheless.
    EXPECT_NEAR(passes.level_set.surface_distance(slot), plane<D>(x), 1e-6);
  });
}

TYPED_TEST(LevelSets, of_round_bodies_are_distances_to_the_error_of_cubic_interpolation) {
  constexpr int D = TypeParam::dimension;
  constexpr int upper = 31;
  const Passes<D> passes(upper, round_body<D>, true);
  int layered = 0;
  passes.inside(upper, 2, [&](const Point<D>& x, std::int64_t slot) {
    const double exact = round_body<D>(x);
    // Deep inside, where nothing reads them, closest points of neighbouring nodes are more than a
    // cell apart, and a node may keep that of its neighbour: 0.2 too far at half of the radius.
    if (exact < -4.2 || exact > 6) return;
    layered += std::abs(exact) > 1.8;
    // 3/128 of the fourth derivative, up to 3/R^3 in each direction, at the surface.
    EXPECT_NEAR(passes.nodes.values[slot], exact, D * 9. / 128 / std::pow(8.3 - 2, 3));
  });
  EXPECT_GT(layered, 100);
}

/// Largest error of phi in the ghost band around a round body, reinitialised from `slope` times the
/// distance [cells].
template <int D>
double first_order_error(double radius, double slope) {
  const int upper = static_cast<int>(2 * radius + 16);
  const auto distance = [&](const Point<D>& x) {
    double square = 0;
    for (int a = 0; a < D; ++a) square += std::pow(x[a] - upper / 2. - 0.1 * a, 2);
    return std::sqrt(square) - radius;
  };
  const Passes<D> passes(
      upper, [&](const Point<D>& x) { return slope * distance(x); }, true,
      Reinitialisation::first_order);
  double worst = 0;
  passes.inside(upper, 1, [&](const Point<D>& x, std::int64_t slot) {
    const double right = distance(x);
    if (std::abs(right) < 4.2) {
      worst = std::max(worst, std::abs(passes.nodes.values[slot] - right));
    }
  });
  return worst;
}

// Differences over a cell see the slope of phi half a cell away, where it is wrong by 1/(2 R): over
// the band this adds up to some tenths of a cell over the radius in cells.
TYPED_TEST(LevelSets, of_round_bodies_become_distances_at_first_order_as_in_the_paper) {
  constexpr int D = TypeParam::dimension;
  for (const double slope : {0.7, 1., 1.5}) {
    const double coarse = first_order_error<D>(6.3, slope),
                 fine = first_order_error<D>(12.6, slope);
    EXPECT_LT(coarse, 0.6) << slope;
    EXPECT_LT(fine, 0.6 * coarse) << slope;
    EXPECT_GT(fine, 0.01) << "of closest points it is 1e-4";
  }
}

TYPED_TEST(LevelSets, of_first_order_keep_what_remeshing_gave_until_they_are_reinitialised) {
  constexpr int D = TypeParam::dimension;
  constexpr int upper = 27;
  const Passes<D> passes(
      upper, [](const Point<D>& x) { return 0.8 * plane<D>(x); }, false,
      Reinitialisation::first_order);
  passes.inside(upper, 9, [&](const Point<D>& x, std::int64_t slot) {
    if (std::abs(plane<D>(x)) > 4.2) return;
    EXPECT_EQ(passes.nodes.values[slot], passes.before[slot]);
  });
}

TYPED_TEST(LevelSets, keep_their_sign_everywhere) {
  constexpr int D = TypeParam::dimension;
  constexpr int upper = 31;
  const Passes<D> passes(upper, round_body<D>, true);
  passes.inside(upper, 0, [&](const Point<D>& x, std::int64_t slot) {
    EXPECT_EQ(passes.nodes.values[slot] < 0, round_body<D>(x) < 0);
  });
}

}  // namespace
}  // namespace pliant::test

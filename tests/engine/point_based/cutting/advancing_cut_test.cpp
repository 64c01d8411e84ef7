#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/point_based/cutting/cut_bonds.hpp"
#include "tests/engine/point_based/cutting/bonds.hpp"

namespace pliant::point_based {
namespace {

using namespace tests;

TEST(advancing_cut, a_cut_that_advances_in_small_steps_is_the_same_as_one_in_large_steps) {
  const LatticeBonds<2> lattice({20, 20}, 0.1);
  CutBonds<2> fine = lattice.cut_by(CutRule::transparency, {2, 2});
  CutBonds<2> coarse = lattice.cut_by(CutRule::transparency, {2, 2});
  fine.add_cut();
  coarse.add_cut();
  for (int k = 0; k <= 64; ++k) fine.advance(0, {{-0.2 + 0.025 * k, 1}});
  coarse.advance(0, {{-0.2, 1}});
  coarse.advance(0, {{1.4, 1}});
  for (std::size_t b = 0; b < fine.factors().size(); ++b) {
    EXPECT_NEAR(fine.factors()[b], coarse.factors()[b], 1e-12);
  }
}

// Two cuts that meet, one of which ends inside the body. The front found after one large step
// equals the one updated in small steps.
TEST(advancing_cut, a_front_that_is_followed_is_that_of_the_whole_cut) {
  const LatticeBonds<3> lattice({8, 8, 8}, 0.125);
  const auto cut_in = [&](int steps) {
    CutBonds<3> cut = lattice.cut_by(CutRule::transparency, {1, 1, 1});
    for (int blade = 0; blade < 2; ++blade) cut.add_cut();
    const auto share = [steps](int k) { return k / static_cast<double>(steps); };
    for (int k = 0; k <= steps; ++k) {
      const double y = -0.125 + 1.25 * share(k);
      cut.advance(0, {{0.5, y, 0.375}, {0.5, y, 1.125}});
    }
    for (int k = 0; k <= steps; ++k) {
      const double x = 1.125 - 0.625 * share(k);
      cut.advance(1, {{x, -0.125, 0.7}, {x, 1.125, 0.7}});
    }
    return cut;
  };
  const CutBonds<3> whole = cut_in(1), followed = cut_in(10);
  int released = 0, retained = 0;
  for (std::size_t b = 0; b < whole.factors().size(); ++b) {
    ASSERT_NEAR(followed.factors()[b], whole.factors()[b], 1e-12);
    released += whole.factors()[b] == 0;
    retained += whole.factors()[b] > 0 && whole.factors()[b] < 1;
  }
  EXPECT_GT(released, 500);
  EXPECT_GT(retained, 50);
}

// A blade that turns once about one of its ends cuts out a disc. Its front is the circle.
TEST(advancing_cut, a_blade_that_turns_about_its_end_leaves_no_front_there) {
  constexpr double radius = 0.4;
  CutSurface<3> disc;
  for (int k = 0; k <= 48; ++k) {
    const double angle = 2 * std::numbers::pi * k / 48;
    std::vector<MaterialPoint<3>> edge;
    for (int i = 0; i <= 4; ++i) {
      const double r = radius * i / 4;
      edge.push_back({0.5 + r * std::cos(angle), 0.5 + r * std::sin(angle), 0.5});
    }
    disc.add_station(edge);
  }
  CutFront<3> front([](const MaterialPoint<3>&) { return true; }, 0.1);
  const std::vector<CutSurface<3>> cuts = {disc};
  front.update(cuts, 0);
  // The sides of a polygon of 48 corners are nearer than the circle by 0.2 %.
  for (const double r : {0., 0.1, 0.2, 0.3}) {
    EXPECT_NEAR(front.distance({0.5 + r, 0.5, 0.52}, 1), std::hypot(radius - r, 0.02), 0.002) << r;
  }
}

TEST(advancing_cut, the_parts_of_a_body_follow_a_blade_as_the_whole_body_does) {
  const LatticeBonds<2> lattice({20, 10}, 0.1);
  for (const CutRule rule :
       {CutRule::visibility, CutRule::transparency, CutRule::product, CutRule::enrichment_grid}) {
    CutBonds<2> whole = lattice.cut_by(rule, {2, 1});
    CutBonds<2> parts = lattice.cut_by(rule, {2, 1}, {0, 50, 64, 130});
    whole.add_cut();
    parts.add_cut();
    for (double y = -0.05; y < 0.8; y += 0.11) {
      const std::vector<std::int32_t> changed = whole.advance(0, {{0.8, y}});
      EXPECT_EQ(parts.advance(0, {{0.8, y}}), changed);
    }
    EXPECT_TRUE(std::ranges::equal(parts.factors(), whole.factors()));
  }
}

TEST(advancing_cut, an_advance_names_the_nodes_near_it_only) {
  const LatticeBonds<2> lattice({40, 20}, 0.1);
  CutBonds<2> cut = lattice.cut_by(CutRule::transparency, {4, 2});
  cut.add_cut();
  cut.advance(0, {{-0.2, 1}});
  cut.advance(0, {{2, 1}});
  const std::vector<double> before(cut.factors().begin(), cut.factors().end());
  const std::vector<std::int32_t> changed = cut.advance(0, {{2.05, 1}});
  EXPECT_GT(changed.size(), 4u);
  EXPECT_LT(changed.size(), 40u);
  EXPECT_TRUE(std::is_sorted(changed.begin(), changed.end()));
  for (std::size_t i = 0; i < lattice.positions.size(); ++i) {
    bool has_changed = false;
    for (std::int64_t b = cut.bonds().first[i]; b < cut.bonds().first[i + 1]; ++b) {
      has_changed = has_changed || before[b] != cut.factors()[b];
    }
    EXPECT_EQ(has_changed,
              std::binary_search(changed.begin(), changed.end(), static_cast<std::int32_t>(i)));
  }
}

}  // namespace
}  // namespace pliant::point_based

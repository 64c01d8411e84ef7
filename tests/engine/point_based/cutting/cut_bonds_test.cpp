#include "engine/point_based/cutting/cut_bonds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "engine/point_based/cutting/connected_parts.hpp"
#include "tests/engine/point_based/cutting/bonds.hpp"

namespace pliant::point_based {
namespace {

using namespace tests;

const CutRule all_rules[] = {CutRule::visibility, CutRule::transparency, CutRule::product,
                             CutRule::enrichment_grid};

std::vector<double> part_volumes(const CutBonds<2>& cut, const std::vector<double>& volumes) {
  return connected_parts(cut.bonds().first, cut.bonds().neighbour, cut.factors(), volumes).volumes;
}
std::vector<double> part_volumes(const CutBonds<3>& cut, const std::vector<double>& volumes) {
  return connected_parts(cut.bonds().first, cut.bonds().neighbour, cut.factors(), volumes).volumes;
}

TEST(cut_bonds, a_complete_cut_in_2d_leaves_no_bond_across) {
  const LatticeBonds<2> lattice({20, 10}, 0.1);
  for (const CutRule rule : all_rules) {
    CutBonds<2> cut = lattice.cut_by(rule, {2, 1});
    cut.add_cut();
    for (double y = -0.05; y < 1.2; y += 0.11) cut.advance(0, {{0.8, y}});
    for_each_bond(cut, [&](std::size_t i, std::size_t j, double factor) {
      const bool is_across = (lattice.positions[i][0] < 0.8) != (lattice.positions[j][0] < 0.8);
      if (rule == CutRule::product) {
        // The rule leaks where pieces meet.
        EXPECT_LE(factor, is_across ? 0.01 : 1);
      } else {
        EXPECT_EQ(factor, is_across ? 0 : 1) << static_cast<int>(rule);
      }
    });
    const std::vector<double> volumes = part_volumes(cut, lattice.volumes);
    if (rule == CutRule::product) continue;
    ASSERT_EQ(volumes.size(), 2u);
    EXPECT_NEAR(volumes[0], 0.8, 1e-12);
    EXPECT_NEAR(volumes[1], 1.2, 1e-12);
  }
}

TEST(cut_bonds, a_complete_cut_in_3d_leaves_no_bond_across) {
  const LatticeBonds<3> lattice({8, 8, 8}, 0.125);
  for (const CutRule rule :
       {CutRule::visibility, CutRule::transparency, CutRule::enrichment_grid}) {
    CutBonds<3> cut = lattice.cut_by(rule, {1, 1, 1});
    cut.add_cut();
    // The plane x + z = 0.9, swept along y by a blade longer than the body.
    for (double y = -0.1; y < 1.2; y += 0.17) cut.advance(0, {{1.4, y, -0.5}, {-0.5, y, 1.4}});
    int across = 0;
    for_each_bond(cut, [&](std::size_t i, std::size_t j, double factor) {
      const auto side = [&](std::size_t n) {
        return lattice.positions[n][0] + lattice.positions[n][2] < 0.9;
      };
      if (side(i) != side(j)) ++across;
      EXPECT_EQ(factor, side(i) == side(j) ? 1 : 0) << static_cast<int>(rule);
    });
    EXPECT_GT(across, 1000);
    EXPECT_EQ(part_volumes(cut, lattice.volumes).size(), 2u);
  }
}

// Cell centres on the plane of the cut join one side, and none is isolated.
TEST(cut_bonds, a_cut_through_nodes_separates_the_body_too) {
  const LatticeBonds<2> lattice({11, 11}, 0.1);
  CutBonds<2> cut = lattice.cut_by(CutRule::transparency, {1.1, 1.1});
  cut.add_cut();
  for (int k = 0; k <= 13; ++k) cut.advance(0, {{0.1 * k - 0.1, 0.55}});
  const std::vector<double> volumes = part_volumes(cut, lattice.volumes);
  ASSERT_EQ(volumes.size(), 2u);
  EXPECT_NEAR(volumes[0], 0.55, 1e-12);
  EXPECT_NEAR(volumes[1], 0.66, 1e-12);
}

TEST(cut_bonds, crossing_and_branching_cuts_make_four_parts_and_three) {
  const LatticeBonds<2> lattice({20, 20}, 0.1);
  for (const CutRule rule :
       {CutRule::visibility, CutRule::transparency, CutRule::enrichment_grid}) {
    CutBonds<2> crossing = lattice.cut_by(rule, {2, 2});
    CutBonds<2> branching = lattice.cut_by(rule, {2, 2});
    for (int k = 0; k < 2; ++k) crossing.add_cut(), branching.add_cut();
    for (int k = 0; k <= 11; ++k) {
      const double s = 0.2 * k - 0.1;
      crossing.advance(0, {{s, 1.02}});
      crossing.advance(1, {{0.6, s}});
      branching.advance(0, {{s, 1.02}});
    }
    for (int k = 0; k <= 6; ++k) branching.advance(1, {{0.6, 1.02 + 0.2 * k}});
    EXPECT_EQ(part_volumes(crossing, lattice.volumes).size(), 4u) << static_cast<int>(rule);
    EXPECT_EQ(part_volumes(branching, lattice.volumes).size(), 3u) << static_cast<int>(rule);
  }
}

// One blade goes all the way round, or four cut one side each, from corner to corner.
TEST(cut_bonds, a_closed_cut_divides_the_body) {
  const LatticeBonds<2> lattice({20, 20}, 0.1);
  CutBonds<2> circle = lattice.cut_by(CutRule::transparency, {2, 2});
  circle.add_cut();
  for (int k = 0; k <= 40; ++k) {
    const double angle = 2 * std::numbers::pi * k / 40;
    circle.advance(0, {{1.01 + 0.6 * std::cos(angle), 1.02 + 0.6 * std::sin(angle)}});
  }
  EXPECT_EQ(part_volumes(circle, lattice.volumes).size(), 2u);

  const MaterialPoint<2> corners[] = {{0.52, 0.47}, {1.58, 0.47}, {1.58, 1.43}, {0.52, 1.43}};
  CutBonds<2> path = lattice.cut_by(CutRule::transparency, {2, 2});
  CutBonds<2> sides = lattice.cut_by(CutRule::transparency, {2, 2});
  path.add_cut();
  for (int side = 0; side < 4; ++side) {
    sides.add_cut();
    for (int k = 0; k <= 20; ++k) {
      MaterialPoint<2> x;
      for (int a = 0; a < 2; ++a) {
        x[a] = corners[side][a] + (corners[(side + 1) % 4][a] - corners[side][a]) * k / 20;
      }
      sides.advance(side, {x});
      if (k > 0 || side == 0) path.advance(0, {x});
    }
  }
  EXPECT_EQ(part_volumes(path, lattice.volumes).size(), 2u);
  EXPECT_EQ(part_volumes(sides, lattice.volumes).size(), 2u);
}

TEST(cut_bonds, a_tube_that_is_punched_out_is_a_part) {
  const LatticeBonds<3> lattice({8, 8, 8}, 0.125);
  CutBonds<3> cut = lattice.cut_by(CutRule::transparency, {1, 1, 1});
  cut.add_cut();
  for (int k = 0; k <= 40; ++k) {
    const double angle = 2 * std::numbers::pi * k / 40;
    const double x = 0.5 + 0.3 * std::cos(angle), y = 0.5 + 0.3 * std::sin(angle);
    cut.advance(0, {{x, y, -0.1}, {x, y, 1.1}});
  }
  EXPECT_EQ(part_volumes(cut, lattice.volumes).size(), 2u);
}

TEST(cut_bonds, a_blade_that_goes_back_leaves_the_front_where_it_was) {
  const LatticeBonds<3> lattice({8, 8, 8}, 0.125);
  CutBonds<3> there = lattice.cut_by(CutRule::transparency, {1, 1, 1});
  CutBonds<3> back = lattice.cut_by(CutRule::transparency, {1, 1, 1});
  // The blade is at x = k/20 - 0.1; it turns at x = 0.5, between two rows of nodes.
  const auto move = [](CutBonds<3>& cut, int k) {
    const double x = 0.05 * k - 0.1;
    cut.advance(0, {{x, -0.1, 0.46}, {x, 1.1, 0.46}});
  };
  for (CutBonds<3>* cut : {&there, &back}) {
    cut->add_cut();
    for (int k = 0; k <= 12; ++k) move(*cut, k);
  }
  for (int k = 11; k >= -1; --k) move(back, k);
  int retained = 0;
  for (std::size_t b = 0; b < there.factors().size(); ++b) {
    ASSERT_EQ(back.factors()[b], there.factors()[b]);
    retained += there.factors()[b] > 0 && there.factors()[b] < 1;
  }
  EXPECT_GT(retained, 50);
  // The front of the whole cut is the same.
  CutFront<3> front([](const MaterialPoint<3>&) { return true; }, 0.125);
  front.update(back.cuts(), 0);
  EXPECT_NEAR(front.distance({0.57, 0.5, 0.46}, 1), 0.07, 1e-12);
}

TEST(cut_bonds, both_directions_of_a_bond_keep_the_same_share) {
  const LatticeBonds<2> lattice({20, 20}, 0.1);
  for (const CutRule rule : {CutRule::visibility, CutRule::transparency}) {
    CutBonds<2> cut = lattice.cut_by(rule, {2, 2});
    cut.add_cut();
    for (int k = 0; k <= 5; ++k) cut.advance(0, {{0.21 * k - 0.1, 1 + 0.03 * k}});
    std::map<std::pair<std::size_t, std::size_t>, double> of;
    for_each_bond(cut, [&](std::size_t i, std::size_t j, double f) { of[{i, j}] = f; });
    for (const auto& [bond, factor] : of) {
      EXPECT_EQ(factor, (of[{bond.second, bond.first}]));
      EXPECT_TRUE(factor >= 0 && factor <= 1);
    }
  }
}

/// Sum of the factors of all bonds when the front of a straight cut is at x.
double sum_of_factors(CutRule rule, double front) {
  const LatticeBonds<2> lattice({20, 20}, 0.1);
  CutBonds<2> cut = lattice.cut_by(rule, {2, 2});
  cut.add_cut();
  cut.advance(0, {{-0.2, 1}});
  cut.advance(0, {{front, 1}});
  double sum = 0;
  for (const double factor : cut.factors()) sum += factor;
  return sum;
}

// (CU.1): the front moves in steps of an eighth of the spacing.
TEST(cut_bonds, transparency_releases_bonds_smoothly_and_visibility_in_jumps) {
  const auto largest_share_of_a_step = [](CutRule rule) {
    double largest = 0;
    for (int k = 0; k < 8; ++k) {
      largest = std::max(largest, sum_of_factors(rule, 1 + 0.0125 * k) -
                                      sum_of_factors(rule, 1 + 0.0125 * (k + 1)));
    }
    return largest / (sum_of_factors(rule, 1) - sum_of_factors(rule, 1.1));
  };
  EXPECT_LT(largest_share_of_a_step(CutRule::transparency), 0.2);
  EXPECT_GT(largest_share_of_a_step(CutRule::visibility), 0.35);
}

}  // namespace
}  // namespace pliant::point_based

#include "engine/remeshed/contact/facing_surfaces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace pliant::remeshed {
namespace {

constexpr double spacing = 0.1, step = 1e-6;

template <int D>
using Distance = std::function<double(const Point<D>&)>;

/// The particles of a body on its lattice, with differences of phi over two spacings as gradients.
template <int D>
struct Samples {
  Lattice<D> lattice;
  SurfaceSamples<D> surface;

  Samples(const Distance<D>& phi, double shift) {
    lattice.spacing = spacing;
    lattice.origin.fill(-2 + shift);
    Cell<D> cell = {};
    std::vector<Site<double, D>> sites;
    surface.lower.fill(-1), surface.upper.fill(41);
    add(phi, cell, 0, sites);
    surface.cells.cover(surface.lower, surface.upper, {}, 2.6, sites.size());
    surface.cells.sort(sites.size(), [&](auto&& f) {
      for (const auto& site : sites) f(site);
    });
  }

  void add(const Distance<D>& phi, Cell<D>& cell, int axis, std::vector<Site<double, D>>& sites) {
    if (axis < D) {
      for (cell[axis] = 0; cell[axis] < 40; ++cell[axis]) add(phi, cell, axis + 1, sites);
      return;
    }
    const Point<D> x = lattice.node(cell);
    if (phi(x) >= 0 || phi(x) < -4 * spacing) return;
    Point<D> gradient, place;
    for (int a = 0; a < D; ++a) {
      Point<D> up = x, down = x;
      up[a] += spacing;
      down[a] -= spacing;
      gradient[a] = (phi(up) - phi(down)) / (2 * spacing);
      place[a] = cell[a];
    }
    surface.record.push_back(static_cast<int>(sites.size()));
    surface.level_set.push_back(phi(x) / spacing);
    surface.gradient.push_back(gradient);
    sites.push_back({place, static_cast<std::int32_t>(sites.size())});
  }
};

/// The distance to a block between `lower` and `upper`, exact inside.
template <int D>
Distance<D> box(const Point<D>& lower, const Point<D>& upper) {
  return [=](const Point<D>& x) {
    double distance = -1e9;
    for (int a = 0; a < D; ++a) distance = std::max({distance, x[a] - upper[a], lower[a] - x[a]});
    return distance;
  };
}

template <int D>
FacingSurfaces<D> faces_at(const Distance<D>& own, const Distance<D>& other, const Point<D>& x) {
  const Samples<D> a(own, 0.013), b(other, 0.037);
  FacingSearch<D> search;
  FacingSurfaces<D> found;
  EXPECT_TRUE(search.find({a.surface, a.lattice}, {b.surface, b.lattice}, x, found)) << x[0];
  return found;
}

TEST(facing_surfaces, of_equal_blocks_are_their_faces_up_to_their_edges) {
  const auto lower = box<2>({-1, -1}, {1, 0}), upper = box<2>({-1, 0.02}, {1, 1});
  for (const double x : {0., 0.8, 0.93, 1.}) {
    const FacingSurfaces<2> found = faces_at<2>(lower, upper, {x, 0});
    EXPECT_NEAR(found.normal[1], 1, step) << x;
    EXPECT_NEAR(found.gap, 0.02, step) << x;
    EXPECT_NEAR(found.depth, 0, step) << x;
    EXPECT_NEAR(found.cover, 1, 1e-3) << x;
  }
}

// Beside the edge of the upper body, x lies on its side, above its bottom.
TEST(facing_surfaces, are_those_below_a_place_on_a_side) {
  const auto lower = box<2>({-1, -1}, {1, 0}), upper = box<2>({-0.5, 0}, {0.5, 1});
  const FacingSurfaces<2> found = faces_at<2>(upper, lower, {0.5, 0.08});
  EXPECT_NEAR(found.normal[1], -1, step);
  EXPECT_NEAR(found.depth, 0.08, step);
  EXPECT_NEAR(found.gap, 0, step);
}

// The share of a cell of the wider body that lies below the narrower one.
TEST(facing_surfaces, of_a_wider_body_are_covered_as_far_as_the_other_one_reaches) {
  const auto lower = box<2>({-1, -1}, {1, 0}), upper = box<2>({-0.5, 0}, {0.5, 1});
  for (const double beyond : {-0.6, -0.4, 0., 0.3}) {
    const FacingSurfaces<2> found = faces_at<2>(lower, upper, {0.5 + beyond * spacing, 0});
    EXPECT_NEAR(found.cover, std::clamp(0.5 - beyond, 0., 1.), 1e-3) << beyond;
    EXPECT_NEAR(found.gap, 0, step);
  }
}

TEST(facing_surfaces, are_those_of_plane_faces_in_3d) {
  const auto lower = box<3>({-1, -1, -1}, {1, 1, 0}), upper = box<3>({-0.5, -1, 0}, {0.5, 1, 1});
  const FacingSurfaces<3> found = faces_at<3>(lower, upper, {0.5, 0.2, 0});
  EXPECT_NEAR(found.normal[2], 1, step);
  EXPECT_NEAR(found.gap, 0, step);
  EXPECT_NEAR(found.cover, 0.5, 1e-3);
}

// Values and slopes of phi at the particles give the gap of round bodies to third order: here the
// curvature 1/R alone would displace it by r^2/(2 R), some hundredths of the spacing.
TEST(facing_surfaces, of_round_bodies_are_not_displaced_by_their_curvature) {
  const auto disc = [](double height) -> Distance<2> {
    return [=](const Point<2>& x) { return std::hypot(x[0], x[1] - height) - 1; };
  };
  const FacingSurfaces<2> found = faces_at<2>(disc(-1), disc(1.005), {0, 0});
  EXPECT_NEAR(found.normal[1], 1, 2e-3);
  EXPECT_NEAR(found.gap, 0.005, 0.01 * spacing);
  EXPECT_EQ(found.cover, 1);
}

TEST(facing_surfaces, are_none_where_the_other_body_is_far_away) {
  const Samples<2> a(box<2>({-1, -1}, {1, 0}), 0), b(box<2>({-1, 0.5}, {1, 1}), 0);
  FacingSearch<2> search;
  FacingSurfaces<2> found;
  EXPECT_FALSE(search.find({a.surface, a.lattice}, {b.surface, b.lattice}, {0, 0}, found));
}

}  // namespace
}  // namespace pliant::remeshed

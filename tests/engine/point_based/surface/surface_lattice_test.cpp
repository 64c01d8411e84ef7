#include "engine/point_based/surface/surface_lattice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "engine/undeformed/body.hpp"

namespace pliant::test {
namespace {

using point_based::SurfaceLattice;

// A load on an end acts on the facets in a thin region there: it is too small unless this is the
// whole end for any spacing.
TEST(surface_lattice, of_a_box_has_its_faces_at_spacings_that_do_not_divide_it) {
  Shape beam;
  beam.kind = Shape::Kind::box;
  beam.lower = {0, -1, -0.5};
  beam.upper = {10, 1, 0.5};
  for (const double spacing : {2. / 3, 0.4, 0.3, 0.21}) {
    SCOPED_TRACE(spacing);
    double area = 0, end = 0;
    for (const auto& facet : SurfaceLattice<3>(beam, spacing).facets()) {
      const auto a = undeformed::area_vector<3>({facet[0].place, facet[1].place, facet[2].place});
      const double size = std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
      area += size;
      bool is_at_end = true;
      for (const auto& corner : facet) is_at_end = is_at_end && corner.place[0] > 9.999;
      if (is_at_end) end += size;
    }
    EXPECT_NEAR(area, 2 * (2 + 10 + 20), 1e-6);
    EXPECT_NEAR(end, 2, 1e-6);
  }
}

// The corner of the quarter and its straight sides are on the lattice. From a point on a side, the
// line across a cell runs along the side up to the circle.
TEST(surface_lattice, of_a_quarter_of_a_disc_follows_its_sides_to_the_circle) {
  Shape disc, box, quarter;
  disc.kind = Shape::Kind::ball;
  disc.radius = 1;
  box.kind = Shape::Kind::box;
  box.upper = {9, 9, 9};
  quarter.kind = Shape::Kind::intersect;
  quarter.operands = {disc, box};
  for (const double spacing : {0.125, 0.1}) {
    double length = 0;
    Point<2> sum = {};
    for (const auto& facet : SurfaceLattice<2>(quarter, spacing).facets()) {
      const auto a = undeformed::area_vector<2>({facet[0].place, facet[1].place});
      length += std::hypot(a[0], a[1]);
      for (int axis = 0; axis < 2; ++axis) sum[axis] += std::max(a[axis], 0.);
    }
    EXPECT_NEAR(length, 2 + std::numbers::pi / 2, 0.005) << spacing;
    for (const double side : sum) EXPECT_NEAR(side, 1, 1e-6) << spacing;
  }
}

// Some points of this lattice are exactly on the circle, such as (0.6, 0.8).
TEST(surface_lattice, of_a_disc_is_one_closed_line) {
  Shape disc;
  disc.kind = Shape::Kind::ball;
  disc.radius = 1;
  std::map<SurfaceLattice<2>::Name, int> segments_at;
  for (const auto& facet : SurfaceLattice<2>(disc, 0.02).facets()) {
    for (const auto& corner : facet) ++segments_at[corner.name];
  }
  EXPECT_GT(segments_at.size(), 300);
  for (const auto& [name, segments] : segments_at) EXPECT_EQ(segments, 2);
}

}  // namespace
}  // namespace pliant::test

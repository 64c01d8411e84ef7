#include "engine/case/attached_walls.hpp"

#include <gtest/gtest.h>

#include "engine/geometry/free_surface.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "tests/engine/geometry/shapes.hpp"

namespace pliant {
namespace {

using namespace tests;

TEST(attached_walls, pressure_regions_are_no_walls_and_periodic_ends_are) {
  Case a_case;
  a_case.boundaries.resize(3);
  a_case.boundaries[0].kind = BoundaryCase::Kind::pressure;
  a_case.boundaries[1].kind = BoundaryCase::Kind::fixed;
  a_case.boundaries[1].geometry = half_space({0, 1, 0}, {0, -1, 0});
  a_case.boundaries[2].kind = BoundaryCase::Kind::slip_wall;
  a_case.boundaries[2].geometry = half_space({0, -1, 0}, {0, 1, 0});
  a_case.periodic.axis = {true, false, false};
  a_case.periodic.lower = {-0.5, 0, 0};
  a_case.periodic.upper = {0.5, 0, 0};
  const std::vector<Shape> walls = attached_walls(a_case);
  ASSERT_EQ(walls.size(), 4U);
  const Shape block = box({-0.5, -1, 0}, {0.5, 1, 0});
  EXPECT_EQ(signed_distance(free_surface(block, walls, 2), {0.3, 0.2, 0}, 2), -infinity);
}

}  // namespace
}  // namespace pliant

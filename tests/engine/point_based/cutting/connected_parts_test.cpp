#include "engine/point_based/cutting/connected_parts.hpp"

#include <gtest/gtest.h>

namespace pliant::point_based {
namespace {

TEST(connected_parts, are_joined_by_bonds_with_weight_only) {
  // 0 - 1   2 - 3 - 4, and a bond 1 - 2 without weight.
  const std::vector<std::int64_t> first = {0, 1, 3, 5, 7, 8};
  const std::vector<std::int32_t> neighbour = {1, 0, 2, 1, 3, 2, 4, 3};
  std::vector<double> factors = {1, 1, 0, 0, 1, 1, 0.1, 0.1};
  const std::vector<double> volumes = {1, 2, 3, 4, 5};
  ConnectedParts parts = connected_parts(first, neighbour, factors, volumes);
  EXPECT_EQ(parts.part_of, (std::vector<std::int32_t>{0, 0, 1, 1, 1}));
  EXPECT_EQ(parts.volumes, (std::vector<double>{3, 12}));
  factors[3] = 0.5;  // one direction is enough
  parts = connected_parts(first, neighbour, factors, volumes);
  EXPECT_EQ(parts.volumes, std::vector<double>{15});
}

}  // namespace
}  // namespace pliant::point_based

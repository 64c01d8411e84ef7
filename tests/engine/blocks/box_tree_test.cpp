#include "engine/blocks/box_tree.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>

namespace pliant {
namespace {

template <int D>
std::vector<Box<D>> random_boxes(int count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(0, 10), size(0, 0.7);
  std::vector<Box<D>> boxes(count);
  for (Box<D>& box : boxes) {
    for (int a = 0; a < D; ++a) {
      box.lower[a] = place(random);
      box.upper[a] = box.lower[a] + size(random);
    }
  }
  return boxes;
}

template <int D>
void expect_all_near_boxes(int count) {
  const std::vector<Box<D>> boxes = random_boxes<D>(count);
  const BoxTree<D> tree(boxes);
  constexpr double squared_radius = 1.1 * 1.1;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (const std::size_t from : {std::size_t{0}, i + 1}) {
      std::vector<std::size_t> found, expected;
      tree.for_each_near(boxes[i], squared_radius, from,
                         [&](std::size_t j) { found.push_back(j); });
      for (std::size_t j = from; j < boxes.size(); ++j) {
        if (squared_gap(boxes[i], boxes[j]) <= squared_radius) expected.push_back(j);
      }
      ASSERT_EQ(found, expected);
    }
  }
}

TEST(box_tree, finds_all_near_boxes_in_ascending_order) {
  for (const int count : {0, 1, 2, 3, 64, 257}) {
    expect_all_near_boxes<2>(count);
    expect_all_near_boxes<3>(count);
  }
}

TEST(box_tree, gaps_are_distances_between_the_nearest_points) {
  const Box<2> unit = {{0, 0}, {1, 1}};
  EXPECT_EQ(squared_gap(unit, Box<2>{{0.5, 0.5}, {3, 3}}), 0);
  EXPECT_EQ(squared_gap(unit, Box<2>{{3, 0}, {4, 1}}), 4);
  EXPECT_EQ(squared_gap(Box<2>{{4, 5}, {6, 6}}, unit), 9 + 16);
  EXPECT_EQ(squared_gap(unit, Box<2>{}), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace pliant

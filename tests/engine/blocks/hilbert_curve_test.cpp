#include "engine/blocks/hilbert_curve.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

namespace pliant {
namespace {

template <int D>
void expect_a_path_through(int bits) {
  const std::uint32_t side = std::uint32_t{1} << bits;
  std::map<std::uint64_t, std::array<std::uint32_t, D>> point_at;
  std::array<std::uint32_t, D> x = {};
  while (true) {
    const std::uint64_t key = hilbert_key<D>(x, bits);
    EXPECT_TRUE(point_at.emplace(key, x).second) << "two points at " << key;
    int a = 0;
    while (a < D && ++x[a] == side) x[a++] = 0;
    if (a == D) break;
  }
  EXPECT_EQ(point_at.begin()->first, 0u);
  EXPECT_EQ(point_at.rbegin()->first, point_at.size() - 1);
  for (auto next = std::next(point_at.begin()); next != point_at.end(); ++next) {
    int steps = 0;
    for (int a = 0; a < D; ++a) {
      steps += std::abs(static_cast<int>(next->second[a]) -
                        static_cast<int>(std::prev(next)->second[a]));
    }
    ASSERT_EQ(steps, 1) << "before key " << next->first;
  }
}

TEST(hilbert_curve, passes_each_grid_point_once_and_steps_to_adjacent_ones) {
  expect_a_path_through<2>(1);
  expect_a_path_through<2>(6);
  expect_a_path_through<3>(1);
  expect_a_path_through<3>(4);
}

TEST(hilbert_curve, keys_use_all_bits_of_the_coordinates) {
  constexpr std::uint32_t last2 = (std::uint32_t{1} << hilbert_bits<2>)-1;
  constexpr std::uint32_t last3 = (std::uint32_t{1} << hilbert_bits<3>)-1;
  EXPECT_NE(hilbert_key<2>({last2, last2}), hilbert_key<2>({last2, last2 - 1}));
  EXPECT_NE(hilbert_key<3>({last3, last3, last3}), hilbert_key<3>({last3 - 1, last3, last3}));
  EXPECT_LT(hilbert_key<2>({last2, 0}), std::uint64_t{1} << (2 * hilbert_bits<2>));
  EXPECT_LT(hilbert_key<3>({last3, 0, 0}), std::uint64_t{1} << (3 * hilbert_bits<3>));
}

}  // namespace
}  // namespace pliant

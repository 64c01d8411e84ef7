#include "engine/lattice/layout.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/engine/lattice/random_cells.hpp"

namespace pliant::test {
namespace {

/// Layouts of random cells: rows with holes, single packs, empty rows.
template <class Space>
struct RandomLayout : testing::Test {
  static constexpr int dimension = Space::dimension;
  static constexpr int block_reach = 10;

  RandomLayout() { build(random_occupancy<dimension>(lower(), upper(), 0.02, 7), {}, 100); }

  static Cell<dimension> lower() { return diagonal<dimension>(-8); }
  static Cell<dimension> upper() {
    Cell<dimension> cell = diagonal<dimension>(dimension == 2 ? 40 : 8);
    cell[0] = 150;
    return cell;
  }

  void build(const Occupancy<dimension>& map, const Cell<dimension>& period,
             std::int64_t block_slots) {
    slots.build(map, period, static_cast<int>(map.slots() / block_slots) + 1, block_reach);
  }

  /// Calls f(slot, cell, segment) for every slot of every segment.
  template <class F>
  void for_each_slot(F&& f) const {
    for (const kernels::Segment<dimension>& segment : slots.segments()) {
      Cell<dimension> cell = segment.cell;
      for (int i = 0; i < segment.count; ++i, ++cell[0]) f(segment.first + i, cell, segment);
    }
  }

  Layout<dimension> slots;
};
TYPED_TEST_SUITE(RandomLayout, Dimensions);

TYPED_TEST(RandomLayout, every_marked_cell_has_a_slot_of_its_own) {
  constexpr int D = TypeParam::dimension;
  std::set<std::int64_t> used;
  const std::vector<Cell<D>> cells = marked_cells(this->slots.occupancy());
  ASSERT_GT(cells.size(), 100u);
  for (const Cell<D>& cell : cells) {
    const std::int64_t slot = this->slots.slot(cell);
    ASSERT_GE(slot, Layout<D>::padding);
    ASSERT_LT(slot, this->slots.slots() - Layout<D>::padding);
    EXPECT_TRUE(used.insert(slot).second);
    EXPECT_EQ(this->slots.cell(slot), cell);
  }
}

TYPED_TEST(RandomLayout, segments_hold_whole_packs_and_agree_with_the_slots_of_their_cells) {
  constexpr int D = TypeParam::dimension;
  std::int64_t end = Layout<D>::padding;
  for (const kernels::Segment<D>& segment : this->slots.segments()) {
    EXPECT_EQ(segment.first % 8, 0);
    EXPECT_EQ(segment.count % 8, 0);
    EXPECT_EQ(segment.first, end) << "segments lie side by side in the order of their slots";
    end = segment.first + segment.count;
  }
  EXPECT_EQ(this->slots.slots(), end + Layout<D>::padding);
  this->for_each_slot([&](std::int64_t slot, const Cell<D>& cell, const auto&) {
    ASSERT_EQ(this->slots.slot(cell), slot);
    ASSERT_EQ(this->slots.cell(slot), cell);
  });
}

TYPED_TEST(RandomLayout, neighbouring_rows_lead_to_every_existing_neighbour_and_stay_in_storage) {
  constexpr int D = TypeParam::dimension;
  constexpr int reach = kernels::row_reach;
  this->for_each_slot([&](std::int64_t slot, const Cell<D>& cell, const auto& segment) {
    for_each_cell<D>(diagonal<D>(-reach), diagonal<D>(reach), [&](const Cell<D>& offset) {
      Cell<D> other = cell;
      for (int a = 0; a < D; ++a) other[a] += offset[a];
      const int row = D == 2 ? kernels::row_index<2>(offset[1])
                             : kernels::row_index<3>(offset[1], offset[D - 1]);
      const std::int64_t reached = slot + segment.neighbour_row[row] + offset[0];
      ASSERT_GE(reached, 0);
      ASSERT_LT(reached, this->slots.slots());
      const std::int64_t there = this->slots.slot(other);
      if (there >= 0) {
        ASSERT_EQ(reached, there) << "slot " << slot << ", row " << row;
      }
    });
  });
}

TYPED_TEST(RandomLayout, blocks_divide_the_segments_in_order_and_know_their_extent) {
  constexpr int D = TypeParam::dimension;
  ASSERT_GT(this->slots.blocks().size(), 5u);
  int segment = 0;
  for (const Block<D>& block : this->slots.blocks()) {
    EXPECT_EQ(block.first_segment, segment);
    segment += block.segment_count;
    EXPECT_EQ(block.first_slot, this->slots.segments_of(block)->first);
    std::int64_t count = 0;
    Cell<D> lower = this->slots.segments_of(block)->cell, upper = lower;
    this->slots.for_each_slot(block, [&](std::int64_t, const Cell<D>& cell) {
      ++count;
      for (int a = 0; a < D; ++a) {
        lower[a] = std::min(lower[a], cell[a]);
        upper[a] = std::max(upper[a], cell[a]);
      }
    });
    EXPECT_EQ(block.slot_count, count);
    EXPECT_EQ(block.lower, lower);
    EXPECT_EQ(block.upper, upper);
  }
  EXPECT_EQ(segment, static_cast<int>(this->slots.segments().size()));
}

/// Whether two blocks are within `reach` cells of each other, across any period.
template <int D>
bool come_near(const Block<D>& a, const Block<D>& b, const Cell<D>& period, int reach) {
  bool near = false;
  for_each_cell<D>(diagonal<D>(-1), diagonal<D>(1), [&](const Cell<D>& periods) {
    bool meets = true;
    for (int axis = 0; axis < D; ++axis) {
      const int shift = periods[axis] * period[axis];
      meets = meets && a.lower[axis] + shift - b.upper[axis] <= reach &&
              b.lower[axis] - a.upper[axis] - shift <= reach;
    }
    near = near || meets;
  });
  return near;
}

TYPED_TEST(RandomLayout, blocks_within_reach_are_neighbours_of_each_other_across_periods_too) {
  constexpr int D = TypeParam::dimension;
  Cell<D> period = {};
  for (const bool periodic : {false, true}) {
    if (periodic) {
      for (int a = 0; a < D; ++a) period[a] = this->upper()[a] + 1 - this->lower()[a];
    }
    this->build(this->slots.occupancy(), period, 100);
    const auto& blocks = this->slots.blocks();
    int pairs = 0, apart = 0;
    for (int a = 0; a < static_cast<int>(blocks.size()); ++a) {
      for (int b = 0; b < static_cast<int>(blocks.size()); ++b) {
        const auto& near = this->slots.neighbours()[a];
        const bool listed = std::count(near.begin(), near.end(), b) == 1;
        const bool expected =
            a != b && come_near<D>(blocks[a], blocks[b], period, this->block_reach);
        EXPECT_EQ(listed, expected) << a << " and " << b << (periodic ? ", periodic" : "");
        (expected ? pairs : apart) += 1;
      }
    }
    EXPECT_GT(pairs, 10);
    if (!periodic) {
      EXPECT_GT(apart, 10) << "the example is too small to tell";
    }
  }
}

TYPED_TEST(RandomLayout, a_solid_body_wastes_no_slots_and_long_rows_are_cut) {
  constexpr int D = TypeParam::dimension;
  Cell<D> upper = diagonal<D>(15);
  upper[0] = 2047;
  this->build(random_occupancy<D>({}, upper, 1, 1), {}, 600);
  int longest = 0;
  for (const auto& segment : this->slots.segments()) longest = std::max(longest, segment.count);
  EXPECT_LE(longest, 512);
  EXPECT_GE(longest, 256);
  const std::int64_t cells = D == 2 ? 2048 * 16 : 2048 * 16 * 16;
  const std::int64_t stored = this->slots.slots() - 2 * Layout<D>::padding;
  EXPECT_EQ(stored, cells);
  for (const auto& block : this->slots.blocks()) EXPECT_LE(block.slot_count, 600 + 512);
}

TYPED_TEST(RandomLayout, short_gaps_keep_their_slots_and_runs_lie_side_by_side) {
  constexpr int D = TypeParam::dimension;
  Occupancy<D> map;
  Cell<D> far = {};
  far[0] = 100;
  map.reset({}, far, 0);
  for (const int x : {0, 15, 45}) {
    Cell<D> cell = {};
    cell[0] = x;
    map.mark(cell);
  }
  this->build(map, {}, 100);
  const auto slot = [&](int x) {
    Cell<D> cell = {};
    cell[0] = x;
    return this->slots.slot(cell);
  };
  EXPECT_EQ(slot(15) - slot(0), 15);
  EXPECT_EQ(slot(12), slot(0) + 12);
  EXPECT_EQ(slot(28), -1);
  EXPECT_EQ(slot(42) - slot(15), 1) << "the second run begins three cells before its mark";
}

}  // namespace
}  // namespace pliant::test

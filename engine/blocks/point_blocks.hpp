#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "scheduler/blocks.hpp"

namespace pliant {

/// An order of points in which close points are mostly close in memory, and its division into
/// blocks.
struct PointBlocks {
  /// [slot] number of the point in the input. Points should be stored in this order.
  std::vector<std::int64_t> order;
  /// [block + 1] of each block, a contiguous run of slots; the last entry is the number of points.
  std::vector<std::int64_t> first_slot;
  /// Blocks are neighbours if a point of one is within the radius of a point of the other.
  scheduler::Blocks blocks;
};

/// Divides unordered points into blocks of about `block_size` points along a Hilbert curve.
///
/// `positions[axis][point]` and `radius` have the same unit of length. The sizes of blocks differ
/// by at most one, and neighbours of blocks are in ascending order. The result depends only on the
/// arguments; points at the same place keep their order. Takes O(n log n) time for n points.
///
/// Throws std::invalid_argument for a coordinate or a difference of coordinates that is not finite,
/// different numbers of coordinates, a radius that is negative or not finite, and a block size
/// below 1.
template <class T, int D>
PointBlocks blocks_of_points(const std::array<std::span<const T>, D>& positions, double radius,
                             int block_size);

}  // namespace pliant

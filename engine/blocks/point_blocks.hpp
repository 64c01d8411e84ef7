#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "scheduler/blocks.hpp"

namespace pliant {

/// An order of points in which points that are close are mostly neighbours in memory, cut into
/// blocks.
struct PointBlocks {
  /// [slot] number of the point in the input. Points are to be stored in this order.
  std::vector<std::int64_t> order;
  /// [block + 1] of each block, a contiguous run of slots; the last entry is the number of points.
  std::vector<std::int64_t> first_slot;
  /// Blocks are neighbours when a point of one lies within the radius of a point of the other.
  scheduler::Blocks blocks;
};

/// Cuts points without any order into blocks of about `block_size` points along a Hilbert curve.
///
/// `positions[axis][point]` and `radius` are lengths of one unit. Blocks differ by one point at
/// most, and their neighbours are listed in ascending order. The result is a function of the
/// arguments alone; points at one place keep their order. Takes O(n log n) time for n points.
///
/// Throws std::invalid_argument for a coordinate that is not finite, coordinates whose difference
/// is not finite, numbers of coordinates that differ, a radius that is negative or not finite, and
/// a block size below 1.
template <class T, int D>
PointBlocks blocks_of_points(const std::array<std::span<const T>, D>& positions, double radius,
                             int block_size);

}  // namespace pliant

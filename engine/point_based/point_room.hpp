#pragma once

#include <cstdint>

#include "engine/storage/buffer.hpp"
#include "kernels/point_based/arguments.hpp"

namespace pliant::point_based {

/// Memory for the displacements of the points of one block, [points][point_stride]. A thread reuses
/// it for its next block, so that it stays in the cache; arrays of the body would not.
template <class T>
T* room_for_points(std::int64_t points) {
  thread_local Buffer<T> room;
  room.grow(static_cast<std::size_t>(points * kernels::point_stride), T(0));
  return room.get();
}

}  // namespace pliant::point_based

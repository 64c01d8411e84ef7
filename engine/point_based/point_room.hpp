#pragma once

#include <cstdint>

#include "engine/storage/buffer.hpp"
#include "kernels/point_based/arguments.hpp"

namespace pliant::point_based {

/// Room for the displacements of the points of one block, [points][point_stride], which each thread
/// uses again for its next block: in arrays of the body they would go to memory and back.
template <class T>
T* room_for_points(std::int64_t points) {
  thread_local Buffer<T> room;
  room.grow(static_cast<std::size_t>(points * kernels::point_stride), T(0));
  return room.get();
}

}  // namespace pliant::point_based

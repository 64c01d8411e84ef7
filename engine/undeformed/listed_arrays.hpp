#pragma once

#include <cstddef>
#include <vector>

#include "engine/storage/buffer.hpp"

namespace pliant::undeformed {

/// Lists where arrays begin, as kernels take them.
template <class T>
void list_arrays(std::vector<Buffer<T>>& arrays, std::vector<T*>& listed) {
  listed.resize(arrays.size());
  for (std::size_t i = 0; i < arrays.size(); ++i) listed[i] = arrays[i].get();
}

}  // namespace pliant::undeformed

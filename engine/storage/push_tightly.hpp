#pragma once

#include <cstddef>
#include <vector>

namespace pliant {

/// Appends to a long list that is kept: its memory grows by an eighth instead of doubling. The
/// value may be an element of the list.
template <class V>
void push_tightly(std::vector<V>& list, V value) {
  constexpr std::size_t least = 8;
  if (list.size() == list.capacity()) list.reserve(list.size() + list.size() / 8 + least);
  list.push_back(value);
}

}  // namespace pliant

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

/// Sets the length and all values of such a list.
template <class V>
void assign_tightly(std::vector<V>& list, std::size_t size, V value) {
  if (size > list.capacity()) list.reserve(size + size / 8);
  list.assign(size, value);
}

}  // namespace pliant

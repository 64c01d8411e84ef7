#pragma once

#include <cstdint>

#include "engine/lattice/layout.hpp"

namespace pliant::remeshed {

/// Calls f(neighbour, offset in slots) for the 3^D - 1 cells around a cell of a segment. The offset
/// is right if the neighbour has a slot; otherwise it may lead anywhere.
template <int D, class F>
void for_each_adjacent(const kernels::Segment<D>& segment, const Cell<D>& cell, F&& f) {
  for (int k = D == 3 ? -1 : 0; k <= (D == 3 ? 1 : 0); ++k) {
    for (int j = -1; j <= 1; ++j) {
      for (int i = -1; i <= 1; ++i) {
        if (i == 0 && j == 0 && k == 0) continue;
        Cell<D> other = cell;
        other[0] += i;
        other[1] += j;
        if constexpr (D == 3) other[2] += k;
        f(other, segment.neighbour_row[kernels::row_index<D>(j, k)] + i);
      }
    }
  }
}

}  // namespace pliant::remeshed

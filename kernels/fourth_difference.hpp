#pragma once

#include "kernels/pack.hpp"

namespace pliant::kernels {

/// Slots at -2, -1, 1 and 2 cells along an axis, relative to a slot.
struct LineOffsets {
  std::int64_t away[4];
};

template <class Arch, int D>
inline LineOffsets line_offsets(const Segment<D>& segment, int axis) {
  if (axis == 0) return {{-2, -1, 1, 2}};
  LineOffsets line;
  for (int k = 0; k < 4; ++k) {
    const int cells = k < 2 ? k - 2 : k - 1;
    line.away[k] =
        segment.neighbour_row[axis == 1 ? row_index<D>(cells, 0) : row_index<D>(0, cells)];
  }
  return line;
}

/// delta^4 f along a line, at a register of slots; exactly zero where f is constant.
template <class P>
inline P fourth_difference(const Scalar<P>* centre, const LineOffsets& line) {
  const P two(Scalar<P>(2)), value = load<P>(centre);
  const P inner = load<P>(centre + line.away[1]) + load<P>(centre + line.away[2]);
  const P outer = load<P>(centre + line.away[0]) + load<P>(centre + line.away[3]);
  return fused_minus(P(Scalar<P>(4)), fused_minus(two, value, inner),
                     fused_minus(two, value, outer));
}

}  // namespace pliant::kernels

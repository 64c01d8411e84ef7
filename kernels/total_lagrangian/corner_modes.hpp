#pragma once

#include "kernels/pack.hpp"
#include "kernels/total_lagrangian/arguments.hpp"

/// Cells and their corners: corner c of a cell lies one slot up in every direction whose bit of c
/// is set.
namespace pliant::kernels {

/// Slot offset of the corners' rows: row r holds corners 2 r and 2 r + 1. `side` is 1 from a cell
/// to its corners, -1 from a particle to the cells of which it is a corner.
template <class Arch, int D>
inline std::int64_t corner_row(const Segment<D>& segment, int row, int side) {
  const int dy = side * (row & 1), dz = side * (row >> 1);
  return segment.neighbour_row[row_index<D>(dy, dz)];
}

/// The corner values' modes in place, (TL.2): a fast Walsh transform. Number 0 becomes their sum.
template <class P, int D>
inline void to_modes(P (&value)[1 << D]) {
#pragma GCC unroll 3
  for (int bit = 1; bit < (1 << D); bit <<= 1) {
#pragma GCC unroll 8
    for (int c = 0; c < (1 << D); ++c) {
      if (c & bit) continue;
      const P lower = value[c], upper = value[c | bit];
      value[c] = upper + lower;
      value[c | bit] = upper - lower;
    }
  }
}

/// Sum over the cells around a particle of the force that mode `mode` of each puts on it: the
/// transpose of `to_modes`, taken direction by direction. `row[r]` are the slots that lie r back in
/// the directions other than x.
template <class P, int D>
inline P force_of_mode(const Scalar<P>* force, const std::int64_t (&row)[1 << (D - 1)],
                       std::int64_t slot, int mode) {
  P sum(Scalar<P>(0));
#pragma GCC unroll 4
  for (int r = 0; r < (1 << (D - 1)); ++r) {
    const Scalar<P>* at = force + slot + row[r];
    const P before = load<P>(at - 1), here = load<P>(at);
    const P pair = mode & 1 ? before - here : before + here;
    // Odd numbers of directions in which the mode changes sign and the particle is a lower corner.
    const int lower = (mode >> 1) & ~r;
    const bool negative = ((lower & 1) ^ (lower >> 1 & 1)) != 0;
    sum = negative ? sum - pair : sum + pair;
  }
  return sum;
}

}  // namespace pliant::kernels

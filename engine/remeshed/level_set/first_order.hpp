#pragma once

#include "engine/lattice/layout.hpp"

namespace pliant::remeshed {

/// Number of passes of (RP.74) with steps of h/2. It is enough for the ghost band of 4.2 h, since
/// phi approaches a distance more slowly near the surface, where abs(s) < 1. Must be even.
inline constexpr int first_order_passes = 20;

/// One pass of (RP.74) over a block's nodes, from `from` to `to` [m]; `start` is phi before the
/// first pass. Reads `from` in neighbouring blocks.
template <class T, int D>
void advance_to_distance(const Lattice<D>& lattice, const Layout<D>& layout, const Block<D>& block,
                         const T* start, const T* from, T* to);

}  // namespace pliant::remeshed

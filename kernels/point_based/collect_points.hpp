#pragma once

#include <cstdint>

#include "kernels/point_based/point_lanes.hpp"

namespace pliant::kernels {

/// Copies displacements of own slots and of the halo into the array of points of a block of nodes
/// or elements, and clears forces. Each point also gets its value of `more` [slot], or 0 if that is
/// null.
template <class P, int D, class Block>
inline void collect_points(const Block& block, const Scalar<P>* more) {
  using T = Scalar<P>;
  T* to = block.point;
  const auto put = [&](std::int64_t slot) {
    for (int a = 0; a < D; ++a) to[a] = block.displacement[a][slot];
    for (int a = D; a < point_stride; ++a) to[a] = T(0);
    if (more != nullptr) to[D] = more[slot];
    to += point_stride;
  };
  for (int i = 0; i < block.count; ++i) put(block.first + i);
  for (int i = 0; i < block.halo_count; ++i) put(block.halo[i]);
  const int values = (block.count + block.halo_count) * point_stride;
  for (int i = 0; i < values; ++i) block.force[i] = T(0);
}

}  // namespace pliant::kernels

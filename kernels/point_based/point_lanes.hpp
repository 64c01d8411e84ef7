#pragma once

#include <cstdint>

#include "kernels/pack.hpp"
#include "kernels/point_based/arguments.hpp"

/// Points whose numbers lie in the lanes of a register: from an array of points to components, and
/// back. Here for any register; point_lanes_avx2.hpp has those of AVX2, which transpose in
/// registers.
namespace pliant::kernels {

template <class P, int D>
struct PointLanes {
  using T = Scalar<P>;

  /// value[a] = component a of the points `number[lane]`.
  static void gather(const T* point, const std::uint16_t* number, P (&value)[D]) {
    alignas(64) T lane[D][lanes<P>];
    for (int l = 0; l < lanes<P>; ++l) {
      const T* from = point + point_stride * number[l];
      for (int a = 0; a < D; ++a) lane[a][l] = from[a];
    }
    for (int a = 0; a < D; ++a) value[a] = P::load_aligned(lane[a]);
  }

  /// Subtracts value[a] from component a of the points `number[lane]`, lane by lane: several lanes
  /// may have the same point.
  static void subtract(const P (&value)[D], const std::uint16_t* number, T* point) {
    alignas(64) T lane[D][lanes<P>];
    for (int a = 0; a < D; ++a) value[a].store_aligned(lane[a]);
    for (int l = 0; l < lanes<P>; ++l) {
      T* to = point + point_stride * number[l];
      for (int a = 0; a < D; ++a) to[a] -= lane[a][l];
    }
  }
};

}  // namespace pliant::kernels

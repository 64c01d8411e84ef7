#pragma once

#include <cstdint>

#include "kernels/pack.hpp"
#include "kernels/point_based/arguments.hpp"

/// Transposes points, one in each lane of a register, from an array of points to components, and
/// back. `place[lane]` is where the point begins in the array. This is the version for any
/// register; that in point_lanes_avx2.hpp transposes in registers.
namespace pliant::kernels {

template <class P, int D>
struct PointLanes {
  using T = Scalar<P>;

  /// value[a] = component a of the points at `place[lane]`.
  [[gnu::always_inline]] static void gather(const T* point, const std::uint16_t* place,
                                            P (&value)[D]) {
    alignas(64) T lane[D][lanes<P>];
    for (int l = 0; l < lanes<P>; ++l) {
      const T* from = point + place[l];
      for (int a = 0; a < D; ++a) lane[a][l] = from[a];
    }
    for (int a = 0; a < D; ++a) value[a] = P::load_aligned(lane[a]);
  }

  /// Subtracts value[a] from component a of the points at `place[lane]`, lane by lane, since
  /// several lanes may have the same point.
  [[gnu::always_inline]] static void subtract(const P (&value)[D], const std::uint16_t* place,
                                              T* point) {
    alignas(64) T lane[D][lanes<P>];
    for (int a = 0; a < D; ++a) value[a].store_aligned(lane[a]);
    for (int l = 0; l < lanes<P>; ++l) {
      T* to = point + place[l];
      for (int a = 0; a < D; ++a) to[a] -= lane[a][l];
    }
  }
};

}  // namespace pliant::kernels

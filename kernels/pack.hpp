#pragma once

#include <concepts>
#include <xsimd/xsimd.hpp>

#include "kernels/layout.hpp"

/// The register type of kernels, and the few operations that xsimd lacks.
///
/// Kernels are compiled into one program once for each instruction set. So the type of every
/// emitted function must contain the architecture: templates over the pack, and plain arrays
/// instead of standard containers. Otherwise instruction sets would share functions, and the linker
/// could keep the AVX-512 versions.
namespace pliant::kernels {

/// Fused multiply-add of a pack; xsimd 8.1 has none for AVX-512 (see avx512_fma.hpp). SSE2 has no
/// such instruction: product and sum are rounded separately.
template <class P>
struct FusedMultiplyAdd {
  static P sum(const P& x, const P& y, const P& z) { return xsimd::fma(x, y, z); }
  static P difference(const P& x, const P& y, const P& z) { return xsimd::fnma(x, y, z); }
};

/// The same for plain numbers, for templates over numbers and registers.
template <std::floating_point T>
struct FusedMultiplyAdd<T> {
  static T sum(T x, T y, T z) { return x * y + z; }
  static T difference(T x, T y, T z) { return z - x * y; }
};

/// x y + z
template <class P>
inline P fused(const P& x, const P& y, const P& z) {
  return FusedMultiplyAdd<P>::sum(x, y, z);
}

/// z - x y
template <class P>
inline P fused_minus(const P& x, const P& y, const P& z) {
  return FusedMultiplyAdd<P>::difference(x, y, z);
}

template <class P>
inline P larger(const P& x, const P& y) {
  if constexpr (std::floating_point<P>) {
    return x > y ? x : y;
  } else {
    return xsimd::max(x, y);
  }
}

template <class P>
using Scalar = typename P::value_type;

template <class P>
inline constexpr int lanes = static_cast<int>(P::size);

/// Registers that hold a storage pack of `slots_per_pack` slots.
template <class P>
inline constexpr int registers_per_pack = slots_per_pack / lanes<P>;

template <class P>
inline P load(const Scalar<P>* from) {
  return P::load_unaligned(from);
}

/// Largest value of a register; independent of the order of its lanes.
template <class P>
inline Scalar<P> largest(const P& pack) {
  alignas(64) Scalar<P> lane[lanes<P>];
  pack.store_aligned(lane);
  Scalar<P> value = lane[0];
  for (int l = 1; l < lanes<P>; ++l) value = lane[l] > value ? lane[l] : value;
  return value;
}

/// The first lane that is set in a mask; one must be.
template <class P>
inline int first_lane(const typename P::batch_bool_type& mask) {
  using T = Scalar<P>;
  alignas(64) T is_set[lanes<P>];
  xsimd::select(mask, P(T(1)), P(T(0))).store_aligned(is_set);
  int lane = 0;
  while (is_set[lane] == 0) ++lane;
  return lane;
}

/// Square root of one number by the instruction set of `P`. All instruction sets would share
/// std::sqrt.
template <class P>
inline Scalar<P> square_root(Scalar<P> x) {
  return xsimd::sqrt(P(x)).get(0);
}

}  // namespace pliant::kernels

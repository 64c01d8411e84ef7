#pragma once

#include <type_traits>

#include "kernels/isa.hpp"
#include "kernels/pack.hpp"
#ifdef __AVX512F__
#include "kernels/avx512_fma.hpp"
#endif

/// Sources of kernels are compiled once for each instruction set, which the build names in
/// PLIANT_ISA.
namespace pliant::kernels {

template <Isa isa>
struct ArchOf;
template <>
struct ArchOf<Isa::sse2> {
  using Type = xsimd::sse2;
};
template <>
struct ArchOf<Isa::avx2> {
  using Type = xsimd::fma3<xsimd::avx2>;
};
template <>
struct ArchOf<Isa::avx512> {
  using Type = xsimd::avx512bw;
};

/// The widest instruction set that kernels are compiled for. In single precision, an AVX2 register
/// already holds a whole pack.
template <class T>
inline constexpr Isa widest_of = std::is_same_v<T, float> ? Isa::avx2 : Isa::avx512;

/// A register of an instruction set.
template <Isa isa, class T>
using PackOf = xsimd::batch<T, typename ArchOf<isa>::Type>;

}  // namespace pliant::kernels

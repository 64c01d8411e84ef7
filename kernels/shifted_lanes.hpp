#pragma once

#include <immintrin.h>

#include "kernels/pack.hpp"

/// Shifts values along x by one slot within registers; xsimd 8.1 has no such operation.
namespace pliant::kernels {

/// The last lane of `before`, then all lanes of `here` except the last.
template <class P>
struct ShiftedLanes;

template <>
struct ShiftedLanes<xsimd::batch<double, xsimd::sse2>> {
  using P = xsimd::batch<double, xsimd::sse2>;
  static P of(const P& before, const P& here) { return _mm_shuffle_pd(before, here, 0b01); }
};

template <>
struct ShiftedLanes<xsimd::batch<float, xsimd::sse2>> {
  using P = xsimd::batch<float, xsimd::sse2>;
  static P of(const P& before, const P& here) {
    const __m128 joint = _mm_shuffle_ps(before, here, _MM_SHUFFLE(0, 0, 3, 3));
    return _mm_shuffle_ps(joint, here, _MM_SHUFFLE(2, 1, 2, 0));
  }
};

#ifdef __AVX2__
template <>
struct ShiftedLanes<xsimd::batch<double, xsimd::fma3<xsimd::avx2>>> {
  using P = xsimd::batch<double, xsimd::fma3<xsimd::avx2>>;
  static P of(const P& before, const P& here) {
    return _mm256_shuffle_pd(_mm256_permute2f128_pd(before, here, 0x21), here, 0b0101);
  }
};

template <>
struct ShiftedLanes<xsimd::batch<float, xsimd::fma3<xsimd::avx2>>> {
  using P = xsimd::batch<float, xsimd::fma3<xsimd::avx2>>;
  static P of(const P& before, const P& here) {
    const __m256i joint = _mm256_castps_si256(_mm256_permute2f128_ps(before, here, 0x21));
    return _mm256_castsi256_ps(_mm256_alignr_epi8(_mm256_castps_si256(here), joint, 12));
  }
};
#endif

#ifdef __AVX512F__
template <>
struct ShiftedLanes<xsimd::batch<double, xsimd::avx512bw>> {
  using P = xsimd::batch<double, xsimd::avx512bw>;
  static P of(const P& before, const P& here) {
    return _mm512_castsi512_pd(
        _mm512_alignr_epi64(_mm512_castpd_si512(here), _mm512_castpd_si512(before), 7));
  }
};
#endif

}  // namespace pliant::kernels

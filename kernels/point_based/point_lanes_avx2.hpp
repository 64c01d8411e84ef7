#pragma once

#include <immintrin.h>

#include "kernels/point_based/point_lanes.hpp"

namespace pliant::kernels {

/// Eight points in single precision: two halves of four, transposed in parallel.
template <int D>
struct PointLanes<xsimd::batch<float, xsimd::fma3<xsimd::avx2>>, D> {
  using P = xsimd::batch<float, xsimd::fma3<xsimd::avx2>>;

  [[gnu::always_inline]] static __m256 pair(const float* point, std::uint16_t low,
                                            std::uint16_t high) {
    return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_load_ps(point + low)),
                                _mm_load_ps(point + high), 1);
  }

  [[gnu::always_inline]] static void gather(const float* point, const std::uint16_t* place,
                                            P (&value)[D]) {
    const __m256 p0 = pair(point, place[0], place[4]), p1 = pair(point, place[1], place[5]);
    const __m256 p2 = pair(point, place[2], place[6]), p3 = pair(point, place[3], place[7]);
    const __m256 xy01 = _mm256_unpacklo_ps(p0, p1), xy23 = _mm256_unpacklo_ps(p2, p3);
    value[0] = _mm256_shuffle_ps(xy01, xy23, 0x44);
    value[1] = _mm256_shuffle_ps(xy01, xy23, 0xee);
    if constexpr (D == 3) {
      const __m256 z01 = _mm256_unpackhi_ps(p0, p1), z23 = _mm256_unpackhi_ps(p2, p3);
      value[2] = _mm256_shuffle_ps(z01, z23, 0x44);
    }
  }

  [[gnu::always_inline]] static void take(float* point, std::uint16_t low, std::uint16_t high,
                                          __m256 value) {
    float* to = point + low;
    _mm_store_ps(to, _mm_sub_ps(_mm_load_ps(to), _mm256_castps256_ps128(value)));
    to = point + high;
    _mm_store_ps(to, _mm_sub_ps(_mm_load_ps(to), _mm256_extractf128_ps(value, 1)));
  }

  // The fourth component of a force is unused. The order of the lanes differs from that in other
  // registers, but sums in double do not depend on it.
  [[gnu::always_inline]] static void subtract(const P (&value)[D], const std::uint16_t* place,
                                              float* point) {
    const __m256 x = value[0], y = value[1];
    __m256 z = _mm256_setzero_ps();
    if constexpr (D == 3) z = value[2];
    const __m256 xy01 = _mm256_unpacklo_ps(x, y), xy23 = _mm256_unpackhi_ps(x, y);
    const __m256 z01 = _mm256_unpacklo_ps(z, z), z23 = _mm256_unpackhi_ps(z, z);
    take(point, place[0], place[4], _mm256_shuffle_ps(xy01, z01, 0x44));
    take(point, place[1], place[5], _mm256_shuffle_ps(xy01, z01, 0xee));
    take(point, place[2], place[6], _mm256_shuffle_ps(xy23, z23, 0x44));
    take(point, place[3], place[7], _mm256_shuffle_ps(xy23, z23, 0xee));
  }
};

/// Four points in double precision.
template <int D>
struct PointLanes<xsimd::batch<double, xsimd::fma3<xsimd::avx2>>, D> {
  using P = xsimd::batch<double, xsimd::fma3<xsimd::avx2>>;

  [[gnu::always_inline]] static __m256d at(const double* point, std::uint16_t place) {
    return _mm256_load_pd(point + place);
  }

  [[gnu::always_inline]] static void gather(const double* point, const std::uint16_t* place,
                                            P (&value)[D]) {
    const __m256d p0 = at(point, place[0]), p1 = at(point, place[1]);
    const __m256d p2 = at(point, place[2]), p3 = at(point, place[3]);
    const __m256d xz01 = _mm256_unpacklo_pd(p0, p1), xz23 = _mm256_unpacklo_pd(p2, p3);
    const __m256d y01 = _mm256_unpackhi_pd(p0, p1), y23 = _mm256_unpackhi_pd(p2, p3);
    value[0] = _mm256_permute2f128_pd(xz01, xz23, 0x20);
    value[1] = _mm256_permute2f128_pd(y01, y23, 0x20);
    if constexpr (D == 3) value[2] = _mm256_permute2f128_pd(xz01, xz23, 0x31);
  }

  [[gnu::always_inline]] static void take(double* point, std::uint16_t place, __m256d value) {
    double* to = point + place;
    _mm256_store_pd(to, _mm256_sub_pd(_mm256_load_pd(to), value));
  }

  [[gnu::always_inline]] static void subtract(const P (&value)[D], const std::uint16_t* place,
                                              double* point) {
    const __m256d x = value[0], y = value[1];
    __m256d z = _mm256_setzero_pd();
    if constexpr (D == 3) z = value[2];
    const __m256d xy02 = _mm256_unpacklo_pd(x, y), xy13 = _mm256_unpackhi_pd(x, y);
    const __m256d z02 = _mm256_unpacklo_pd(z, z), z13 = _mm256_unpackhi_pd(z, z);
    take(point, place[0], _mm256_permute2f128_pd(xy02, z02, 0x20));
    take(point, place[1], _mm256_permute2f128_pd(xy13, z13, 0x20));
    take(point, place[2], _mm256_permute2f128_pd(xy02, z02, 0x31));
    take(point, place[3], _mm256_permute2f128_pd(xy13, z13, 0x31));
  }
};

}  // namespace pliant::kernels

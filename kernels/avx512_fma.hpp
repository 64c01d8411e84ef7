#pragma once

#include <immintrin.h>

#include "kernels/pack.hpp"

namespace pliant::kernels {

template <>
struct FusedMultiplyAdd<xsimd::batch<double, xsimd::avx512bw>> {
  using P = xsimd::batch<double, xsimd::avx512bw>;
  static P sum(const P& x, const P& y, const P& z) { return _mm512_fmadd_pd(x, y, z); }
  static P difference(const P& x, const P& y, const P& z) { return _mm512_fnmadd_pd(x, y, z); }
};

}  // namespace pliant::kernels

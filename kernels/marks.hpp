#pragma once

#include <immintrin.h>

#include "kernels/pack.hpp"

namespace pliant::kernels {

/// Marks as numbers of the type of `P`; xsimd would convert them one by one.
template <class P>
inline P load_marks(const Mark* from) {
  if constexpr (std::same_as<Scalar<P>, Mark>) {
    return load<P>(from);
#ifdef __AVX512F__
  } else if constexpr (lanes<P> == 8) {
    return _mm512_cvtps_pd(_mm256_loadu_ps(from));
#endif
#ifdef __AVX2__
  } else if constexpr (lanes<P> == 4) {
    return _mm256_cvtps_pd(_mm_loadu_ps(from));
#endif
  } else {
    return _mm_set_pd(from[1], from[0]);
  }
}

}  // namespace pliant::kernels

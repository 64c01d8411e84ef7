#include "engine/bench/fma_loop.hpp"

namespace pliant::bench {

double fma_loop_avx2(std::int64_t rounds) {
  return fma_loop<xsimd::batch<double, xsimd::fma3<xsimd::avx2>>>(rounds);
}

}  // namespace pliant::bench

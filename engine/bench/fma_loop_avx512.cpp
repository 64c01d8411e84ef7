#include "engine/bench/fma_loop.hpp"
#include "kernels/avx512_fma.hpp"

namespace pliant::bench {

double fma_loop_avx512(std::int64_t rounds) {
  return fma_loop<xsimd::batch<double, xsimd::avx512bw>>(rounds);
}

}  // namespace pliant::bench

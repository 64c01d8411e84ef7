#pragma once

#include <cstdint>

#include "kernels/pack.hpp"

namespace pliant::bench {

/// Chains of dependent multiply-adds; two units with latency four need at least eight.
inline constexpr int fma_chains = 12;

/// `rounds` multiply-adds in each lane of each chain, only in registers. The result is returned so
/// that the compiler does not remove the loop.
template <class P>
kernels::Scalar<P> fma_loop(std::int64_t rounds) {
  using T = kernels::Scalar<P>;
  const P factor(T(0.999999)), summand(T(1e-6));
  P x[fma_chains];
#pragma GCC unroll 16
  for (int k = 0; k < fma_chains; ++k) x[k] = P(T(k));
  for (std::int64_t i = 0; i < rounds; ++i) {
#pragma GCC unroll 16
    for (P& chain : x) chain = kernels::fused(chain, factor, summand);
  }
#pragma GCC unroll 16
  for (int k = 1; k < fma_chains; ++k) x[0] = x[0] + x[k];
  return kernels::largest(x[0]);
}

/// The loop in double, compiled for each instruction set.
double fma_loop_sse2(std::int64_t rounds);
double fma_loop_avx2(std::int64_t rounds);
double fma_loop_avx512(std::int64_t rounds);

}  // namespace pliant::bench

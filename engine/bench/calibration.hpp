#pragma once

#include "engine/storage/buffer.hpp"
#include "kernels/isa.hpp"

/// What the machine can do at the moment of asking. Other programs and other guests of the same
/// host take their share without notice, so that a figure means little without one of these taken
/// beside it.
namespace pliant::bench {

/// Multiply-adds in registers on `threads` threads, two operations each [flop/s]. SSE2 has no fused
/// ones: there a multiplication and an addition.
double fma_peak(kernels::Isa isa, int threads);

/// The arrays of the triad a = b + 3 c, far larger than a second-level cache.
class Triad {
 public:
  Triad();

  /// Bytes per second on `threads` threads, each array counted once (as STREAM does).
  double operator()(int threads);

 private:
  static constexpr std::size_t length = std::size_t{1} << 24;  // 128 MiB an array
  Buffer<double> a_, b_, c_;
};

}  // namespace pliant::bench

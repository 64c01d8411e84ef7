#pragma once

#include "engine/storage/buffer.hpp"
#include "kernels/isa.hpp"

/// The present speed of the machine. Other programs and guests of the host use a changing share of
/// it, so a figure is only meaningful with a speed measured at the same time.
namespace pliant::bench {

/// Multiply-adds in registers on `threads` threads, two operations each [flop/s]. SSE2 has no fused
/// ones and uses a multiplication and an addition.
double fma_peak(kernels::Isa isa, int threads);

/// Time in which a cache line goes from the processor of one thread to that of another and back
/// [s], the mean over all other threads; 0 on one thread. Where a virtual machine's processors lie
/// behind different caches it is several times as long, and whatever threads pass to each other
/// takes so much longer.
double hand_over(int threads);

/// The triad a = b + 3 c, with arrays much larger than a second-level cache.
class Triad {
 public:
  Triad();

  /// Bytes per second on `threads` threads; each array counts once, as in STREAM.
  double operator()(int threads);

 private:
  static constexpr std::size_t length = std::size_t{1} << 24;  // 128 MiB an array
  Buffer<double> a_, b_, c_;
};

}  // namespace pliant::bench

#pragma once

#include <xmmintrin.h>

namespace pliant::scheduler {

/// While it exists, the calling thread computes with zero in place of subnormal numbers, which are
/// smaller than 1.2e-38 in single precision and 2.2e-308 in double. Ahead of a wave the motion of
/// particles at rest decays through such numbers, and a processor takes some hundred cycles for
/// each operation with one. Every node of a step runs under it, on any thread and in any order, so
/// that results do not depend on the settings of the caller.
class ZeroSubnormals {
 public:
  ZeroSubnormals() : before_(_mm_getcsr()) {
    constexpr unsigned zero_operands = 0x0040, zero_results = 0x8000;
    _mm_setcsr(before_ | zero_operands | zero_results);
  }
  ZeroSubnormals(const ZeroSubnormals&) = delete;
  ZeroSubnormals& operator=(const ZeroSubnormals&) = delete;
  ~ZeroSubnormals() { _mm_setcsr(before_); }

 private:
  unsigned before_;
};

}  // namespace pliant::scheduler

#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace pliant {

/// Whether a sample is due after `step` steps, such that the last 1/128 to 1/64 of the steps so far
/// lie between two samples. It does not depend on when a run ends.
inline bool is_sampled(std::int64_t step) {
  const auto share = static_cast<std::uint64_t>(std::max<std::int64_t>(1, step / 64));
  return step % static_cast<std::int64_t>(std::bit_floor(share)) == 0;
}

/// Instants at multiples of `every`; `every` = 0 means never.
class Schedule {
 public:
  explicit Schedule(double every) : every_(every) {}
  double next() const { return every_ > 0 ? every_ * static_cast<double>(count_ + 1) : HUGE_VAL; }
  /// Whether `time` has reached the next instant; if so, advances to the one after it.
  bool reached(double time) {
    if (time < next() * (1 - 1e-12)) return false;
    ++count_;
    return true;
  }
  std::int64_t count() const { return count_; }
  void restore(std::int64_t count) { count_ = count; }

 private:
  double every_;
  std::int64_t count_ = 0;
};

}  // namespace pliant

#pragma once

#include <cmath>
#include <cstdint>

namespace pliant {

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
  /// The same, but advances to the first instant after `time`: what comes next follows from the
  /// time alone.
  bool passed(double time) {
    if (time < next() * (1 - 1e-12)) return false;
    count_ = static_cast<std::int64_t>(time / every_ * (1 + 1e-12));
    return true;
  }
  std::int64_t count() const { return count_; }
  void restore(std::int64_t count) { count_ = count; }

 private:
  double every_;
  std::int64_t count_ = 0;
};

}  // namespace pliant

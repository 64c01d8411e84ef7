#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/case/case.hpp"

namespace pliant {

/// Collects differences from an exact velocity for the measurement `velocity_error`.
class VelocityError {
 public:
  VelocityError(const MeasurementCase& measurement, double time)
      : measurement_(measurement), time_(time) {}

  /// Adds a particle at `x` [m] with `components` components of the velocity `u` [m/s].
  void add(const Vector& x, const Vector& u, int components) {
    for (int a = 0; a < components; ++a) {
      const double error = std::abs(u[a] - measurement_.exact[a](x[0], x[1], x[2], time_));
      largest_ = std::max(largest_, error);
      square_ += error * error;
    }
    ++count_;
  }

  /// The error in the norm of the measurement, divided by its reference.
  double value() const {
    const double error =
        measurement_.norm == MeasurementCase::Norm::maximum
            ? largest_
            : std::sqrt(square_ / static_cast<double>(std::max<std::int64_t>(count_, 1)));
    return error / measurement_.reference;
  }

 private:
  const MeasurementCase& measurement_;
  double time_;
  double largest_ = 0, square_ = 0;
  std::int64_t count_ = 0;
};

}  // namespace pliant

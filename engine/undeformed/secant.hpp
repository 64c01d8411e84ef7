#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pliant::undeformed {

/// The stiffness and the inertia of the motion since the last sample, (TL.10): sums over particles
/// with the displacement D since then.
struct Secant {
  double stiffness = 0;  ///< D.(F' - F), F' the forces at the last sample [J]
  double inertia = 0;    ///< D.m D, without mass scaling [kg m^2]; 0 if nothing has moved enough
  /// The same of blocks whose stiffness is lost in rounding, which is no larger than this.
  double rounding = 0, inertia_in_rounding = 0;

  Secant& operator+=(const Secant& other) {
    stiffness += other.stiffness;
    inertia += other.inertia;
    rounding += other.rounding;
    inertia_in_rounding += other.inertia_in_rounding;
    return *this;
  }
  /// The Rayleigh quotient, 0 where the stiffness is negative [1/s^2].
  double frequency2() const { return stiffness > 0 && inertia > 0 ? stiffness / inertia : 0; }
  /// What it is at most where all is lost in rounding [1/s^2].
  double most_frequency2() const { return rounding / inertia_in_rounding; }
};

/// Steps until the next sample after one that has found the frequency `omega` [1/s], `last` steps
/// after that before, (TL.10). A sample takes almost as long as a step. Where a growing load ends,
/// a body begins to vibrate whose motion has had no frequency until then.
inline std::int64_t steps_until_sample(double omega, double time_step, std::int64_t last) {
  constexpr double radians = 0.05;
  constexpr std::int64_t least = 4, most = 32;
  const double steps = radians / std::max(omega * time_step, radians / most);
  return std::clamp(static_cast<std::int64_t>(steps), least, std::clamp(2 * last, least, most));
}

}  // namespace pliant::undeformed

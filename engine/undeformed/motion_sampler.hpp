#pragma once

#include <cstdint>
#include <vector>

#include "engine/undeformed/body.hpp"
#include "engine/undeformed/clock.hpp"
#include "engine/undeformed/secant.hpp"

namespace pliant::undeformed {

/// How a step changes the velocity of a particle without walls and contact: to
/// kept v + gained f/m.
template <class T>
struct Kick {
  /// By forces that act for `duration` [s], (TL.8), (PB.10).
  Kick(const Clock& clock, double duration)
      : kept(static_cast<T>((1 - clock.damping * duration / 2) /
                            (1 + clock.damping * duration / 2))),
        gained(static_cast<T>(duration / clock.inertia(duration))) {}

  T kept;    ///< of the velocity, the rest is damped
  T gained;  ///< [s]
};

/// Samples of the motion of bodies for adaptive damping, (TL.10).
template <class T, int D>
class MotionSampler {
 public:
  void prepare_blocks(std::size_t count) { blocks_.assign(count, {}); }

  /// Before a kick: keeps the velocities of some slots, and the displacements at which its forces
  /// act.
  void begin(int block, const Body<T, D>& body, std::int64_t first, std::int64_t count);
  /// With the velocities at the end of the step: compares the displacements and the forces, those
  /// of walls and contact included, with the last sample, which they replace.
  void end(int block, Body<T, D>& body, const Kick<T>& kick);

  /// Sum over the blocks.
  Secant secant() const;

 private:
  struct OfBlock {
    std::int64_t first = 0, count = 0;  ///< of its slots
    std::vector<T> displacement;        ///< [axis][slot]
    std::vector<T> velocity_or_force;   ///< [axis][slot] velocity before the kick, then the force
    Secant secant;
  };
  /// The motion of a block since the last sample; in single precision only what it is at most where
  /// it is so small that its forces are lost in rounding.
  static Secant compare(OfBlock& of, const Body<T, D>& body, const Kick<T>& kick);

  std::vector<OfBlock> blocks_;
};

extern template class MotionSampler<double, 2>;
extern template class MotionSampler<double, 3>;
extern template class MotionSampler<float, 2>;
extern template class MotionSampler<float, 3>;

}  // namespace pliant::undeformed

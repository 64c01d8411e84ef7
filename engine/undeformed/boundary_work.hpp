#pragma once

#include <optional>
#include <vector>

#include "engine/undeformed/body.hpp"
#include "engine/undeformed/state.hpp"

namespace pliant::undeformed {

/// What boundaries do to the particles in a step: walls hold their constrained particles; impulses
/// of walls and the work of walls, loads and gravity (RP.72) are added up. Velocities before and
/// after a step count alike: so the work of a force is exactly what it adds to the kinetic energy.
template <class T, int D>
class BoundaryWork {
 public:
  explicit BoundaryWork(State<D>& state) : state_(state) {}

  /// Makes room for blocks with these constrained particles, body after body.
  void clear_blocks() { work_.clear(); }
  void add_blocks(const Body<T, D>& body);

  /// When a step begins, how long it is, for how long forces act, and for how long particles move
  /// at the velocity that these leave behind [s].
  struct Times {
    double begin, length, kick, drift;
  };
  /// Fixes how walls move in a step; clears the rates of work and the forces of walls in the state.
  void prepare(const Times& times);

  /// Before the particles of a block move; `power` is that of loads and gravity there [W].
  void begin_motion(int block, const Body<T, D>& body, int local, const EnergyBudget& power);
  /// After that: constrained particles go where their walls go, in the order of these: where two
  /// walls meet, the last one counts. What is undone is the impulse of the wall, (TL.8), (PB.10).
  void hold(int block, Body<T, D>& body, int local) { hold(block, body, local, body.displacement); }
  /// The same with displacements that are not yet those of the body.
  void hold(int block, Body<T, D>& body, int local, std::array<Buffer<T>, D>& displacement);
  /// In the end, with the power of loads and gravity then.
  void end_motion(int block, const EnergyBudget& power);

  /// Adds impulses and work of the step to the state, in the order of the blocks; `inertia` is the
  /// sum of m u^2 before the step, `damped` that of m ((u + u')/2)^2 [J], u' the velocities after
  /// it, those of constrained particles before hold(): damping takes that to rounding, (TL.28).
  /// None where contact has changed velocities since.
  void fold(double inertia, std::optional<double> damped);

 private:
  struct BlockWork {
    EnergyBudget energy;             ///< of the step [J]
    EnergyBudget power;              ///< of the velocities that it leaves behind [W]
    double undamped = 0;             ///< what hold() takes of m ((u + u')/2)^2 [J]
    std::vector<Wrench<D>> impulse;  ///< [wall] on the block [N s], [N m s]
    std::vector<Point<D>> before;    ///< [constrained particle] velocity before the step [m/s]
    std::vector<Point<D>> start;     ///< [the same] displacement before the step [m]
  };

  State<D>& state_;
  /// Of a wall in a step.
  struct Motion {
    RigidStep<D> step;
    std::optional<RigidMotion<D>> velocity;  ///< after it; without one the mean of the step
  };

  Times times_ = {};
  std::vector<Motion> walls_;
  std::vector<BlockWork> work_;  ///< [block]
};

extern template class BoundaryWork<double, 2>;
extern template class BoundaryWork<double, 3>;
extern template class BoundaryWork<float, 2>;
extern template class BoundaryWork<float, 3>;

}  // namespace pliant::undeformed

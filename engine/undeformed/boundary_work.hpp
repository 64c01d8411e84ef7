#pragma once

#include <optional>
#include <vector>

#include "engine/undeformed/body.hpp"
#include "engine/undeformed/state.hpp"

namespace pliant::undeformed {

/// The effect of boundaries on the particles in a step. Walls hold their constrained particles.
/// Impulses of walls and the work of walls, loads and gravity (RP.72) are summed. Work uses the
/// mean of the velocities before and after the step, so that it is exactly the gain of kinetic
/// energy.
template <class T, int D>
class BoundaryWork {
 public:
  explicit BoundaryWork(State<D>& state) : state_(state) {}

  /// Makes room for blocks with these constrained particles, body after body.
  void clear_blocks() { work_.clear(); }
  void add_blocks(const Body<T, D>& body);

  /// Start and length of a step, the duration of forces, and how long particles move at the
  /// velocity after these forces [s].
  struct Times {
    double begin, length, kick, drift;
  };
  /// Sets the motion of walls in a step; clears the rates of work and the forces of walls in the
  /// state.
  void prepare(const Times& times);

  /// Called first, before the particles of a block move; `power` is that of loads and gravity [W].
  void begin_motion(int block, const Body<T, D>& body, int local, const EnergyBudget& power);
  /// Called after that: moves constrained particles with their walls. Where two walls meet, the
  /// last one decides. The change of momentum is the impulse of the wall, (TL.8), (PB.10).
  void hold(int block, Body<T, D>& body, int local) { hold(block, body, local, body.displacement); }
  /// The same with displacements that are not those of the body yet.
  void hold(int block, Body<T, D>& body, int local, std::array<Buffer<T>, D>& displacement);
  /// Called after that if contact has changed velocities since, with the slots of the block.
  void after_contact(int block, const Body<T, D>& body, std::int64_t first, std::int64_t count);
  /// Called with the power of loads and gravity at the velocities at the end of the step; again if
  /// contact has changed them since.
  void end_motion(int block, const EnergyBudget& power);

  /// Adds impulses and work of a block to the state; to be called block after block. `inertia` is
  /// the sum of m u^2 before the step [J]. `damped` is that of m ((u + u')/2)^2, to which the loss
  /// by damping is proportional up to rounding without contact, (TL.28); u' are the velocities
  /// after the step, those of constrained particles before hold().
  void fold(int block, double inertia, double damped);

 private:
  /// Two threads that write to one cache line wait for each other.
  struct alignas(64) BlockWork {
    EnergyBudget energy;             ///< of the step [J]
    EnergyBudget power;              ///< of walls at the velocities after the step [W]
    EnergyBudget at_end;             ///< of loads and gravity then [W]
    std::optional<double> inertia;   ///< sum of m u^2 after contact [J]
    double undamped = 0;             ///< part of m ((u + u')/2)^2 that hold() removes [J]
    std::vector<Wrench<D>> impulse;  ///< [wall] on the block [N s], [N m s]
    std::vector<Point<D>> before;    ///< [constrained particle] velocity before the step [m/s]
    std::vector<Point<D>> start;     ///< [constrained particle] displacement before the step [m]
  };

  State<D>& state_;
  /// The motion of a wall in a step.
  struct Motion {
    RigidStep<D> step;
    std::optional<RigidMotion<D>> velocity;  ///< after the step; empty: the mean of the step
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

#pragma once

#include <cstdint>
#include <vector>

#include "engine/blocks/numbering.hpp"
#include "engine/boundaries/walls.hpp"
#include "engine/boundaries/wrench.hpp"
#include "engine/case/case.hpp"
#include "engine/method/energy_budget.hpp"
#include "engine/method/step_clock.hpp"
#include "engine/remeshed/state/body.hpp"

namespace pliant::remeshed {

/// Counters that the next step reads; a checkpoint holds all of them.
struct Clock : StepClock {
  std::int64_t remeshings = 0;
  std::int64_t steps_since_remeshing = 0;
  std::int64_t steps_since_reinitialisation = 0;
  double accumulated_strain = 0;  ///< of (RP.39), since the last remeshing
  double deformation = 0;         ///< max abs(F - I) of (RP.39), since the last remeshing
  double strain_rate = 0;         ///< max abs(eps)_F of (RP.29) in the last step [1/s]
};

/// Momentum budget of a body in contact, see contact_momentum_correction.hpp.
template <int D>
struct MomentumBudget {
  double mass = 0;         ///< M of (RP.87) times that at t = 0 [kg]
  Point<D> momentum = {};  ///< [N s]
};

/// Motion budget of a body with a surface, see free_motion_correction.hpp.
template <int D>
struct MotionBudget {
  double mass = 0;         ///< M of (RP.87) times that after the last remeshing [kg]
  Point<D> momentum = {};  ///< [N s]
  Vector spin = {};        ///< angular momentum about the mass centre [N m s]; in 2D z only
  bool is_known = false;   ///< false if something has held or pushed the body since then
};

/// All bodies of a case, with their walls, clock and budgets.
template <class T, int D>
struct State {
  Clock clock;
  Boundaries<D> boundaries;
  EnergyBudget energy;
  std::vector<WallPose<D>> remeshed_poses;  ///< [wall] at the last remeshing
  std::vector<Wrench<D>> wall_impulse;      ///< [wall] on the bodies, since t = 0 [N s], [N m s]
  std::vector<Point<D>> contact_impulse;    ///< [contact] on its second body, since t = 0 [N s]
  std::vector<Body<T, D>> bodies;
  std::vector<MomentumBudget<D>>
      momentum_budgets;                         ///< [body]; empty without contact between bodies
  std::vector<MotionBudget<D>> motion_budgets;  ///< [body]
  std::vector<BlockOwner> blocks;

  std::int64_t particles() const {
    std::int64_t sum = 0;
    for (const Body<T, D>& body : bodies) sum += body.population.particles;
    return sum;
  }

  /// Size of all fields [B].
  std::size_t bytes() const {
    std::size_t sum = 0;
    for (const Body<T, D>& body : bodies) {
      for (const auto& store : body.stage) sum += store.bytes();
      body.for_each_array([&sum](Field, int, auto components) {
        for (const auto& component : components) sum += component.bytes();
      });
      sum += body.neighbours.bytes() + body.records.bytes();
    }
    return sum;
  }

  /// The body of a block, and the number of the block in it.
  struct Owner {
    Body<T, D>& body;
    int block;
  };
  Owner owner(int block) { return {bodies[blocks[block].body], blocks[block].block}; }
};

}  // namespace pliant::remeshed

#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/remeshed/loads/lone_walls.hpp"
#include "engine/remeshed/loads/surroundings.hpp"
#include "engine/remeshed/loads/wall_push.hpp"
#include "engine/remeshed/loads/wall_work.hpp"
#include "engine/remeshed/state/state.hpp"

namespace pliant::remeshed {

/// What the walls give to the bodies in a step: impulses (RP.65), (RP.105), their moments (RP.115),
/// and their work.
template <class T, int D>
class WallImpulses {
 public:
  WallImpulses(State<T, D>& state, const Case& settings);

  /// Begins a step with these values at its stages; they must outlive it.
  void prepare(double time_step, std::span<const BoundaryValues<D>> values);
  /// (RP.65) for the walls that hold a block, at a stage. Their work is added to `work`.
  WallWork<T, D> of_block(int block, int stage, const Surroundings<D>& around, double& work);
  /// [wall] of a block: impulses, and pushes, of which there are none if no moment is needed.
  Point<D>* impulse(int block) { return impulse_.data() + block * walls(); }
  std::span<WallPush<D>> pushes(int block);
  /// Reads the momentum of a block before a stage, and when the stage has written its state.
  void begin(int block, int stage, const Wrench<D>& force_of_loads);
  void end(int block, int stage);
  /// Adds the step to the state, with [block][stage] body forces in it.
  void fold(const std::vector<std::array<ForceOnBlock<D>, 4>>& body_forces);

  /// [block][wall] impulse on the bodies in the step [N s].
  const std::vector<Point<D>>& of_blocks() const { return impulse_; }
  /// Whether forces of walls depend on the masses of the bodies that they hold, (RP.105).
  bool weigh_held_bodies() const { return lone_walls_.exist(); }

 private:
  std::size_t walls() const { return state_.boundaries.walls.size(); }
  void add_lone_walls(const Point<D>& impulse);
  void share_rest(int axis, double impulse);
  void add_along(int axis, int wall, double impulse);
  void add_moments(const Vector& by_momentum);

  State<T, D>& state_;
  std::vector<char> is_measured_;  ///< [wall] whether a measurement needs its force
  std::vector<char> has_moment_;  ///< [wall] whether its moment is needed: it turns, or is measured
  bool have_moments_;
  LoneWalls<T, D> lone_walls_;
  double time_step_ = 0;
  std::span<const BoundaryValues<D>> values_;   ///< [stage]
  std::vector<Point<D>> impulse_;               ///< [block][wall]
  std::vector<WallPush<D>> push_;               ///< [block][wall]; empty if no moment is needed
  std::vector<Point<D>> whole_;                 ///< [wall] impulse of all blocks
  std::vector<std::vector<WallShare>> shares_;  ///< [block]
  std::vector<char> is_watched_;                ///< [wall] whether its ghosts are summed
  bool needs_momentum_ = false;                 ///< whether momentum gives forces of walls
};

extern template class WallImpulses<double, 2>;
extern template class WallImpulses<double, 3>;
extern template class WallImpulses<float, 2>;
extern template class WallImpulses<float, 3>;

}  // namespace pliant::remeshed

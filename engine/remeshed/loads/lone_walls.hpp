#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "engine/boundaries/wrench.hpp"
#include "engine/remeshed/loads/body_forces.hpp"
#include "engine/remeshed/state/particle_momentum.hpp"
#include "engine/remeshed/state/state.hpp"

namespace pliant::remeshed {

/// Forces of walls from the momentum of the bodies that they hold, (RP.105), which is more accurate
/// than the stress beside them. It gives the force of one wall that alone can act along an axis,
/// and the sum of the forces of several.
template <class T, int D>
class LoneWalls {
 public:
  /// The forces of `measured` walls are needed, and the moments of those with `has_moment`.
  LoneWalls(State<T, D>& state, const Case& settings, const std::vector<char>& measured,
            const std::vector<char>& has_moment);

  /// [axis] the wall that alone can act along it, or -1.
  const std::array<int, D>& along() const { return along_; }
  /// The walls that can act along an axis, if there are several and the force of one is measured.
  const std::vector<int>& together_along(int axis) const { return together_[axis]; }
  /// Whether a wall has edges, beside which its force by (RP.65) has errors.
  bool has_edges(int wall) const { return has_edges_[wall] != 0; }
  bool are_any_together() const {
    return std::ranges::any_of(together_, [](const auto& walls) { return !walls.empty(); });
  }
  /// Whether momentum gives a force along any axis.
  bool exist() const {
    return are_any_together() || std::ranges::any_of(along_, [](int wall) { return wall >= 0; });
  }
  /// Whether momentum gives all components of the force of a wall.
  bool have_all_of(int wall) const;
  /// Whether angular momentum gives its moment: no other wall acts.
  bool have_moment_of(int wall) const {
    return std::ranges::all_of(along_, [wall](int alone) { return alone == wall; });
  }

  void prepare(double time_step);
  /// Reads a block before a stage, and when the stage has written its state.
  void begin(int block, int stage, const Wrench<D>& force_of_loads);
  void end(int block, int stage);
  /// Impulse of the walls on the bodies in the step [N s], and its moment [N m s] where it is
  /// needed, with [block][stage] body forces.
  Wrench<D> impulse(const std::vector<std::array<ForceOnBlock<D>, 4>>& body_forces) const;

 private:
  /// Of a block, or of a body, in one step.
  struct Change {
    ParticleMomentum<D> before, after;
    Vector turning_before = {}, turning_after = {};  ///< angular momentum [N m s]
    Wrench<D> by_loads;                              ///< impulse
    bool is_held = false;                            ///< whether there are ghosts of walls
  };

  State<T, D>& state_;
  std::vector<std::array<bool, D>> acts_;  ///< [wall][axis]
  std::vector<char> has_edges_;            ///< [wall]
  std::array<std::vector<int>, D> together_;
  std::array<int, D> along_;
  bool have_moments_ = false;  ///< whether angular momentum is needed
  double time_step_ = 0;
  std::vector<Change> change_;  ///< [block]
};

extern template class LoneWalls<double, 2>;
extern template class LoneWalls<double, 3>;
extern template class LoneWalls<float, 2>;
extern template class LoneWalls<float, 3>;

}  // namespace pliant::remeshed

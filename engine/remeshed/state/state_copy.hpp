#pragma once

#include <cstdint>
#include <vector>

#include "engine/remeshed/state/state.hpp"

namespace pliant::remeshed {

/// A copy of everything that a step changes, to return to the state before it.
///
/// It contains no neighbour lists, which are not part of the state, and nothing that only a
/// remeshing changes.
template <class T, int D>
class StateCopy {
 public:
  /// Copies the present state. Allocates only when there are more slots than ever before.
  void keep(const State<T, D>& state);
  /// Restores the copied state, bit by bit.
  void put_back(State<T, D>& state) const;
  std::size_t bytes() const;

 private:
  struct OfBody {
    std::vector<std::vector<T>> arrays;  ///< of the state and the stress, [array][slot]
    std::vector<Kind> kind;
    std::vector<PackState> pack_state;
    std::vector<std::vector<std::uint8_t>> active;       ///< [block][ghost]
    std::vector<std::vector<std::array<T, D>>> lasting;  ///< [block][ghost]
    double strain, strain_rate;
  };

  Clock clock_;
  EnergyBudget energy_;
  std::vector<WallPose<D>> wall_pose_;
  std::vector<Wrench<D>> wall_impulse_;
  std::vector<Point<D>> contact_impulse_;
  std::vector<MomentumBudget<D>> momentum_budgets_;
  std::vector<MotionBudget<D>> motion_budgets_;
  std::vector<OfBody> bodies_;
};

extern template class StateCopy<double, 2>;
extern template class StateCopy<double, 3>;
extern template class StateCopy<float, 2>;
extern template class StateCopy<float, 3>;

}  // namespace pliant::remeshed

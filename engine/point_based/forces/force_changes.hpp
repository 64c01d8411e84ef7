#pragma once

#include <vector>

#include "engine/point_based/body.hpp"

namespace pliant::point_based {

/// The stiffness that opposes the present motion of followed bodies, u.(f(t - dt') - f(t)) of
/// (PB.65), in each step.
template <class T, int D>
class ForceChanges {
 public:
  void prepare_blocks(std::size_t count) { blocks_.assign(count, {}); }

  /// Keeps the velocities before the kick: they have moved the nodes since the forces were known
  /// last.
  void begin(int block, const Body<T, D>& body, int local);
  /// Reads the new forces on the nodes, and keeps them for the next step.
  void end(int block, Body<T, D>& body, int local);

  /// Sum over the blocks [W].
  double power() const;

 private:
  struct OfBlock {
    std::vector<T> velocity;  ///< [axis][node]
    double power = 0;         ///< [W]
  };
  std::vector<OfBlock> blocks_;
};

extern template class ForceChanges<double, 2>;
extern template class ForceChanges<double, 3>;
extern template class ForceChanges<float, 2>;
extern template class ForceChanges<float, 3>;

}  // namespace pliant::point_based

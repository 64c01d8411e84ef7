#pragma once

#include <vector>

#include "engine/point_based/body.hpp"
#include "engine/undeformed/secant.hpp"

namespace pliant::point_based {

/// Samples of the motion of bodies for adaptive damping, (PB.65).
template <class T, int D>
class MotionSampler {
 public:
  void prepare_blocks(std::size_t count) { blocks_.assign(count, {}); }

  /// Keeps the displacements at which the forces of this step act.
  void begin(int block, const Body<T, D>& body, int local);
  /// Compares them and the new forces with the last sample, which they replace.
  void end(int block, Body<T, D>& body, int local);

  /// Sum over the blocks.
  undeformed::Secant secant() const;

 private:
  struct OfBlock {
    std::vector<T> displacement;  ///< [axis][node]
    undeformed::Secant secant;
  };
  std::vector<OfBlock> blocks_;
};

extern template class MotionSampler<double, 2>;
extern template class MotionSampler<double, 3>;
extern template class MotionSampler<float, 2>;
extern template class MotionSampler<float, 3>;

}  // namespace pliant::point_based

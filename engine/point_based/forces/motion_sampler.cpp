#include "engine/point_based/forces/motion_sampler.hpp"

namespace pliant::point_based {

template <class T, int D>
void MotionSampler<T, D>::begin(int block, const Body<T, D>& body, int local) {
  const NodeBlock& range = body.blocks[local];
  std::vector<T>& kept = blocks_[block].displacement;
  kept.clear();
  for (const Buffer<T>& component : body.displacement) {
    const T* first = component.get() + range.first;
    kept.insert(kept.end(), first, first + range.nodes);
  }
}

template <class T, int D>
void MotionSampler<T, D>::end(int block, Body<T, D>& body, int local) {
  const NodeBlock& range = body.blocks[local];
  const T* force = body.force.get() + kernels::point_stride * range.first_point();
  OfBlock& of_block = blocks_[block];
  of_block.secant = undeformed::take_sample<T, D>(
      body, range.first, range.nodes,
      [&](int a, std::int64_t slot) {
        return of_block.displacement[a * range.nodes + (slot - range.first)];
      },
      [&](int a, std::int64_t slot) {
        return force[kernels::point_stride * (slot - range.first) + a];
      });
}

template <class T, int D>
undeformed::Secant MotionSampler<T, D>::secant() const {
  undeformed::Secant sum;
  for (const OfBlock& of_block : blocks_) sum += of_block.secant;
  return sum;
}

template class MotionSampler<double, 2>;
template class MotionSampler<double, 3>;
template class MotionSampler<float, 2>;
template class MotionSampler<float, 3>;

}  // namespace pliant::point_based

#include "engine/point_based/forces/force_changes.hpp"

namespace pliant::point_based {

template <class T, int D>
void ForceChanges<T, D>::begin(int block, const Body<T, D>& body, int local) {
  const NodeBlock& range = body.blocks[local];
  std::vector<T>& kept = blocks_[block].velocity;
  kept.clear();
  for (const Buffer<T>& component : body.velocity) {
    const T* first = component.get() + range.first;
    kept.insert(kept.end(), first, first + range.nodes);
  }
}

template <class T, int D>
void ForceChanges<T, D>::end(int block, Body<T, D>& body, int local) {
  const NodeBlock& range = body.blocks[local];
  const T* force = body.force.get() + kernels::point_stride * range.first_point();
  OfBlock& of_block = blocks_[block];
  of_block.power = 0;
  for (int i = 0; i < range.nodes; ++i) {
    for (int a = 0; a < D; ++a) {
      T& previous = body.previous_force[a][range.first + i];
      const T present = force[kernels::point_stride * i + a];
      of_block.power += double{of_block.velocity[a * range.nodes + i]} * (previous - present);
      previous = present;
    }
  }
}

template <class T, int D>
double ForceChanges<T, D>::power() const {
  double sum = 0;
  for (const OfBlock& of_block : blocks_) sum += of_block.power;
  return sum;
}

template class ForceChanges<double, 2>;
template class ForceChanges<double, 3>;
template class ForceChanges<float, 2>;
template class ForceChanges<float, 3>;

}  // namespace pliant::point_based

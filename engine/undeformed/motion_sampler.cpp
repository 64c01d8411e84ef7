#include "engine/undeformed/motion_sampler.hpp"

#include <array>
#include <cmath>

namespace pliant::undeformed {

namespace {

template <class T, int D>
void keep(const std::array<Buffer<T>, D>& components, std::int64_t first, std::int64_t count,
          std::vector<T>& kept) {
  kept.clear();
  for (const Buffer<T>& component : components) {
    kept.insert(kept.end(), component.get() + first, component.get() + first + count);
  }
}

/// The least motion since the last sample, over the displacement, that is not lost in what rounding
/// to T adds to the forces.
template <class T>
constexpr double noticed = sizeof(T) == sizeof(float) ? 0.003 : 0;

}  // namespace

template <class T, int D>
void MotionSampler<T, D>::begin(int block, const Body<T, D>& body, std::int64_t first,
                                std::int64_t count) {
  OfBlock& kept = blocks_[block];
  kept.first = first;
  kept.count = count;
  keep<T, D>(body.displacement, first, count, kept.displacement);
  keep<T, D>(body.velocity, first, count, kept.velocity);
}

template <class T, int D>
bool MotionSampler<T, D>::has_moved(const OfBlock& of, const Body<T, D>& body) {
  if constexpr (noticed<T> == 0) return true;
  double moved = 0, displaced = 0;
  for (int a = 0; a < D; ++a) {
    for (std::int64_t i = 0; i < of.count; ++i) {
      const double now = of.displacement[a * of.count + i];
      moved += std::pow(now - body.sampled_displacement[a][of.first + i], 2);
      displaced += now * now;
    }
  }
  return moved > noticed<T> * noticed<T> * displaced;
}

template <class T, int D>
void MotionSampler<T, D>::end(int block, Body<T, D>& body, const Kick<T>& kick) {
  OfBlock& of = blocks_[block];
  of.secant = {};
  if (!has_moved(of, body)) return;
  for (int a = 0; a < D; ++a) {
    for (std::int64_t i = 0; i < of.count; ++i) {
      const std::int64_t slot = of.first + i;
      if (!body.is_particle(slot)) continue;
      T& last_displacement = body.sampled_displacement[a][slot];
      T& last_force = body.sampled_force[a][slot];
      const T displacement = of.displacement[a * of.count + i];
      const T change = body.velocity[a][slot] - kick.kept * of.velocity[a * of.count + i];
      const T force = body.mass[slot] * change / kick.gained;
      const double moved = double{displacement} - last_displacement;
      of.secant.stiffness += moved * (double{last_force} - force);
      of.secant.inertia += body.mass[slot] * moved * moved;
      last_displacement = displacement;
      last_force = force;
    }
  }
}

template <class T, int D>
Secant MotionSampler<T, D>::secant() const {
  Secant sum;
  for (const OfBlock& of_block : blocks_) sum += of_block.secant;
  return sum;
}

template class MotionSampler<double, 2>;
template class MotionSampler<double, 3>;
template class MotionSampler<float, 2>;
template class MotionSampler<float, 3>;

}  // namespace pliant::undeformed

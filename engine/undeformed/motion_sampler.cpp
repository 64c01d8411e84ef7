#include "engine/undeformed/motion_sampler.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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

/// What rounding to T may add to the force on a particle of the mass `mass` where displacements are
/// up to `displaced` [m]: the modulus of pressure waves times the rounded strain on its faces [N,
/// N/m in 2D].
template <class T, int D>
double rounded_force(const Body<T, D>& body, double mass, double displaced) {
  const double density = body.source->material.density;
  const double speed = kernels::wave_speed_at_rest(body.source->material);
  const double size = std::pow(mass / density, 1.0 / D);
  const double strain = std::numeric_limits<T>::epsilon() * (1 + 2 * displaced / size);
  return strain * density * speed * speed * std::pow(size, D - 1);
}

}  // namespace

template <class T, int D>
void MotionSampler<T, D>::begin(int block, const Body<T, D>& body, std::int64_t first,
                                std::int64_t count) {
  OfBlock& kept = blocks_[block];
  kept.first = first;
  kept.count = count;
  keep<T, D>(body.displacement, first, count, kept.displacement);
  keep<T, D>(body.velocity, first, count, kept.velocity_or_force);
}

template <class T, int D>
Secant MotionSampler<T, D>::compare(OfBlock& of, const Body<T, D>& body, const Kick<T>& kick) {
  constexpr double noticed = 5;  // times what rounding adds
  Secant found;
  double square = 0, largest_mass = 0, displaced = 0;
  for (int a = 0; a < D; ++a) {
    for (std::int64_t i = 0; i < of.count; ++i) {
      const std::int64_t slot = of.first + i;
      if (!body.is_particle(slot)) continue;
      const T displacement = of.displacement[a * of.count + i];
      T& before = of.velocity_or_force[a * of.count + i];
      const T change = body.velocity[a][slot] - kick.kept * before;
      const T force = body.mass[slot] * change / kick.gained;
      const double moved = double{displacement} - body.sampled_displacement[a][slot];
      found.stiffness += moved * (double{body.sampled_force[a][slot]} - force);
      found.inertia += body.mass[slot] * moved * moved;
      before = force;
      if constexpr (sizeof(T) == sizeof(float)) {
        square += moved * moved;
        largest_mass = std::max<double>(largest_mass, body.mass[slot]);
        displaced = std::max<double>(displaced, std::abs(displacement));
      }
    }
  }
  if constexpr (sizeof(T) == sizeof(double)) return found;
  const double rounding =
      noticed * rounded_force(body, largest_mass, displaced) * std::sqrt(square);
  if (std::abs(found.stiffness) > rounding) return found;
  return {.rounding = rounding, .inertia_in_rounding = found.inertia};
}

template <class T, int D>
void MotionSampler<T, D>::end(int block, Body<T, D>& body, const Kick<T>& kick) {
  OfBlock& of = blocks_[block];
  of.secant = compare(of, body, kick);
  if (of.secant.inertia_in_rounding > 0) return;
  for (int a = 0; a < D; ++a) {
    for (std::int64_t i = 0; i < of.count; ++i) {
      const std::int64_t slot = of.first + i;
      if (!body.is_particle(slot)) continue;
      body.sampled_displacement[a][slot] = of.displacement[a * of.count + i];
      body.sampled_force[a][slot] = of.velocity_or_force[a * of.count + i];
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

#pragma once

#include "kernels/pack.hpp"
#include "kernels/point_based/point_lanes.hpp"

namespace pliant::kernels {

/// Sums over nodes, one for each lane of a pack, since additions to a single sum would wait for
/// each other. `P` keeps the code of different instruction sets apart.
template <class P>
struct LaneSums {
  double lane[slots_per_pack] = {};

  double all() const {
    double sum = 0;
    for (const double one : lane) sum += one;
    return sum;
  }
};

/// Adds m u^2 and m ((u + u')/2)^2 of a pack of nodes.
template <class P, int D>
inline void add_inertia(const Scalar<P>* mass, const Scalar<P> (&before)[D][slots_per_pack],
                        const Scalar<P>* const (&after)[D], LaneSums<P>& inertia,
                        LaneSums<P>& of_means) {
  for (int l = 0; l < slots_per_pack; ++l) {
    double square = 0, square_of_mean = 0;
#pragma GCC unroll 3
    for (int a = 0; a < D; ++a) {
      const double u = before[a][l], mean = (u + after[a][l]) / 2;
      square += u * u;
      square_of_mean += mean * mean;
    }
    inertia.lane[l] += mass[l] * square;
    of_means.lane[l] += mass[l] * square_of_mean;
  }
}

/// Adds the forces that other blocks have collected for this one, in the order of the blocks.
template <class P, int D>
inline void add_collected_forces(const PointMotion<Scalar<P>, D>& block) {
  using T = Scalar<P>;
  for (int c = 0; c < block.collected_count; ++c) {
    const CollectedForces<T>& from = block.collected[c];
    for (int i = 0; i < from.count; ++i) {
      T* to = block.force + point_stride * (from.slot[i] - block.first);
      T sum[point_stride];  // lets the compiler add all components at once
      for (int a = 0; a < point_stride; ++a) sum[a] = to[a] + from.force[point_stride * i + a];
      for (int a = 0; a < point_stride; ++a) to[a] = sum[a];
    }
  }
}

/// Moves a register of nodes.
template <class P, int D>
inline void advance_register(const PointMotion<Scalar<P>, D>& block, int local) {
  using T = Scalar<P>;
  std::uint16_t place[lanes<P>];
  for (int l = 0; l < lanes<P>; ++l) place[l] = static_cast<std::uint16_t>(point_stride * l);
  const std::int64_t slot = block.first + local;
  P force[D];
  PointLanes<P, D>::gather(block.force + point_stride * local, place, force);
  const P inverse_mass = load<P>(block.inverse_mass + slot);
  const auto exists = inverse_mass > P(T(0));
#pragma GCC unroll 3
  for (int a = 0; a < D; ++a) {
    if (block.external[a] != nullptr) force[a] = force[a] + load<P>(block.external[a] + slot);
    const P pull =
        xsimd::select(exists, fused(force[a], inverse_mass, P(block.gravity[a])), P(T(0)));
    const P u = load<P>(block.velocity[a] + slot);
    const P next = fused(P(block.gained), pull, P(block.kept) * u);
    next.store_unaligned(block.velocity[a] + slot);
    fused(P(block.drift), next, load<P>(block.displacement[a] + slot))
        .store_unaligned(block.displacement[a] + slot);
  }
}

/// See PointMotion.
template <class P, int D>
PointMotionSums advance_points(const PointMotion<Scalar<P>, D>& block) {
  using T = Scalar<P>;
  add_collected_forces<P, D>(block);
  LaneSums<P> inertia, of_means;
  for (int first = 0; first < block.count; first += slots_per_pack) {
    const std::int64_t slot = block.first + first;
    T before[D][slots_per_pack];
    const T* velocity[D];
    for (int a = 0; a < D; ++a) {
      velocity[a] = block.velocity[a] + slot;
      for (int l = 0; l < slots_per_pack; ++l) before[a][l] = velocity[a][l];
    }
    for (int local = first; local < first + slots_per_pack; local += lanes<P>) {
      advance_register<P, D>(block, local);
    }
    if (block.mass != nullptr) {
      add_inertia<P, D>(block.mass + slot, before, velocity, inertia, of_means);
    }
  }
  return {inertia.all(), of_means.all()};
}

/// See PointMomentum.
template <class P, int D>
std::array<double, D> momentum_of_points(const PointMomentum<Scalar<P>, D>& block) {
  std::array<double, D> momentum;
  for (int a = 0; a < D; ++a) {
    LaneSums<P> sums;
    for (std::int64_t slot = block.first; slot < block.first + block.count;
         slot += slots_per_pack) {
      for (int l = 0; l < slots_per_pack; ++l) {
        sums.lane[l] += static_cast<double>(block.mass[slot + l]) * block.velocity[a][slot + l];
      }
    }
    momentum[a] = sums.all();
  }
  return momentum;
}

template <class P, int D>
void drift_points(const PointDrift<Scalar<P>, D>& block) {
  for (int a = 0; a < D; ++a) {
    for (std::int64_t slot = block.first; slot < block.first + block.count; slot += lanes<P>) {
      fused(P(block.drift), load<P>(block.velocity[a] + slot),
            load<P>(block.displacement[a] + slot))
          .store_unaligned(block.displacement[a] + slot);
    }
  }
}

}  // namespace pliant::kernels

#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/case/case.hpp"
#include "engine/lattice/lattice.hpp"
#include "engine/storage/buffer.hpp"

namespace pliant::undeformed {

/// A point of the undeformed surface on the line between two particles, which it moves with. If it
/// moves with only one particle, both are the same.
template <int D>
struct Vertex {
  std::int32_t first, second;  ///< slots
  double along;                ///< 0 at the first, 1 at the second
  Point<D> start;              ///< undeformed place [m]
};

/// A particle whose velocity a wall prescribes.
template <int D>
struct ConstrainedParticle {
  std::int32_t slot;
  std::int32_t wall;
  Point<D> normal;  ///< outward normal of a slip wall; zero at a no-slip wall
  Point<D> start;   ///< undeformed place [m]
};

/// The common part of the bodies of all methods on the undeformed body: particles that move.
template <class T, int D>
struct Body {
  using Scalar = T;
  static constexpr int dimension = D;

  std::string name;
  const BodyCase* source = nullptr;
  std::int64_t particles = 0, slots = 0;
  Buffer<T> mass;          ///< [kg], 0 where there is no particle
  Buffer<T> inverse_mass;  ///< [1/kg], 0 where there is no particle
  std::array<Buffer<T>, D> displacement, velocity;
  std::array<Buffer<T>, D> traction;  ///< of loads and gravity on each particle [N]
  /// Displacement at the end of a step that an output time divides [m]; otherwise undefined.
  std::array<Buffer<T>, D> end_displacement;
  /// The same for velocities that belong to the ends of steps, and their gain in the step [m/s].
  std::array<Buffer<T>, D> end_velocity, velocity_gain;
  /// Internal forces of the last step, and what contact has added [N]; only in the total Lagrangian
  /// method, for velocities at the ends of steps.
  std::array<Buffer<T>, D> internal;
  /// Displacements [m] and forces [N] at the last sample of the motion; only with adaptive damping,
  /// (TL.10).
  std::array<Buffer<T>, D> sampled_displacement, sampled_force;
  std::vector<std::vector<ConstrainedParticle<D>>> held;  ///< [block]

  bool is_particle(std::int64_t slot) const { return mass[slot] > 0; }
  /// Adds the force [N] that has changed the velocity of a particle by contact.
  void add_contact_force(std::int64_t slot, int axis, double force) {
    if (internal[axis].bytes() > 0) internal[axis][slot] += static_cast<T>(force);
  }
  bool is_sampled() const { return sampled_force[0].bytes() > 0; }

  /// Present place of a point of the surface [m].
  Point<D> position(const Vertex<D>& v) const { return position(v, displacement); }
  /// Its place with these displacements [m].
  Point<D> position(const Vertex<D>& v, const std::array<Buffer<T>, D>& displaced) const {
    Point<D> x = v.start;
    for (int a = 0; a < D; ++a) {
      x[a] += (1 - v.along) * displaced[a][v.first] + v.along * displaced[a][v.second];
    }
    return x;
  }
};

/// The member of a body that holds the displacements at the end of a step.
template <class T, int D>
using Displacements = std::array<Buffer<T>, D> Body<T, D>::*;

template <int D>
Point<D> middle_of(const std::array<Point<D>, D>& x) {
  Point<D> middle = {};
  for (const Point<D>& corner : x) {
    for (int a = 0; a < D; ++a) middle[a] += corner[a] / D;
  }
  return middle;
}

/// The middle of the share of corner v in a facet with a linear load, (PB.67): that of its linear
/// shape function.
template <int D>
Point<D> middle_of_share(const std::array<Point<D>, D>& x, int v) {
  Point<D> middle;
  for (int a = 0; a < D; ++a) {
    middle[a] = x[v][a] / (D + 1);
    for (const Point<D>& corner : x) middle[a] += corner[a] / (D + 1);
  }
  return middle;
}

/// Normal of a segment or a triangle; its length is the area [m^(D-1)].
template <int D>
Point<D> area_vector(const std::array<Point<D>, D>& x) {
  if constexpr (D == 2) {
    return {x[1][1] - x[0][1], x[0][0] - x[1][0]};
  } else {
    Point<3> n, a, b;
    for (int i = 0; i < 3; ++i) {
      a[i] = x[1][i] - x[0][i];
      b[i] = x[2][i] - x[0][i];
    }
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      n[i] = (a[j] * b[k] - a[k] * b[j]) / 2;
    }
    return n;
  }
}

}  // namespace pliant::undeformed

#pragma once

#include <cstdint>
#include <span>

#include "engine/undeformed/body.hpp"
#include "engine/undeformed/held_directions.hpp"

/// Points that move with several particles, and impulses on them. Each particle takes its share of
/// an impulse, so that no momentum is lost, and no angular momentum where the shares put the point
/// where it is.
namespace pliant::undeformed {

/// A particle and how much a point moves with it; of one point, all shares add up to 1.
struct Share {
  std::int32_t slot;
  double weight;
};

/// Displacement [m] or velocity [m/s] of a point, from those of the particles.
template <class T, int D>
Point<D> carried(const std::array<Buffer<T>, D>& of_particles, std::span<const Share> shares) {
  Point<D> sum = {};
  for (const Share& share : shares) {
    for (int a = 0; a < D; ++a) sum[a] += share.weight * of_particles[a][share.slot];
  }
  return sum;
}

/// Velocity of a point along the unit vector `n` for an impulse along it [1/kg]; walls hold
/// particles.
template <class T, int D>
double compliance(const Body<T, D>& body, const HeldDirections<D>& held,
                  std::span<const Share> shares, const Point<D>& n) {
  double sum = 0;
  for (const Share& share : shares) {
    double free = 1;
    if (const auto at = held.find(share.slot); at != held.end()) {
      free = 0;
      for (int i = 0; i < D; ++i) {
        for (int j = 0; j < D; ++j) free += n[i] * at->second[D * i + j] * n[j];
      }
    }
    sum += free * share.weight * share.weight * body.inverse_mass[share.slot];
  }
  return sum;
}

/// Gives a point an impulse [N s], and moves it, in these displacements of the body, by the
/// response to another one, `moved` [kg m].
template <class T, int D>
void push(Body<T, D>& body, std::array<Buffer<T>, D>& displacements, const HeldDirections<D>& held,
          std::span<const Share> shares, const Point<D>& impulse, const Point<D>& moved) {
  for (const Share& share : shares) {
    const double response = share.weight * body.inverse_mass[share.slot];
    const auto at = held.find(share.slot);
    const bool is_held = at != held.end();
    const Point<D> velocity = is_held ? projected<D>(at->second, impulse) : impulse;
    const Point<D> displacement = is_held ? projected<D>(at->second, moved) : moved;
    for (int a = 0; a < D; ++a) {
      body.velocity[a][share.slot] += static_cast<T>(response * velocity[a]);
      displacements[a][share.slot] += static_cast<T>(response * displacement[a]);
    }
  }
}

}  // namespace pliant::undeformed

#pragma once

#include <array>
#include <map>

#include "engine/lattice/point_algebra.hpp"
#include "engine/undeformed/body.hpp"

namespace pliant::undeformed {

/// [slot] the directions that walls leave free for a particle, as a row-major projection. Only
/// particles that a wall holds have an entry.
template <int D>
using HeldDirections = std::map<std::int32_t, std::array<double, D * D>>;

/// The projection for a particle that no wall holds.
template <int D>
std::array<double, D * D> all_directions() {
  std::array<double, D* D> tensor = {};
  for (int a = 0; a < D; ++a) tensor[(D + 1) * a] = 1;
  return tensor;
}

/// The part of `v` in the directions that a projection leaves free.
template <int D>
Point<D> projected(const std::array<double, D * D>& free, const Point<D>& v) {
  Point<D> left = {};
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) left[i] += free[D * i + j] * v[j];
  }
  return left;
}

/// A projection that is also normal to the unit vector `n`; the same if it is so already, up to
/// some degrees.
template <int D>
std::array<double, D * D> without(const std::array<double, D * D>& free, const Point<D>& n) {
  constexpr double least = 0.01;
  const Point<D> along = projected<D>(free, n);
  const double square = dot<D>(along, along);
  if (square < least) return free;
  std::array<double, D* D> rest = free;
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) rest[D * i + j] -= along[i] * along[j] / square;
  }
  return rest;
}

/// The projections of all particles of a body that walls hold.
template <class T, int D>
HeldDirections<D> held_directions(const Body<T, D>& body) {
  HeldDirections<D> held;
  for (const auto& of_block : body.held) {
    for (const ConstrainedParticle<D>& particle : of_block) {
      auto& free = held.insert({particle.slot, all_directions<D>()}).first->second;
      free = particle.normal == Point<D>{} ? std::array<double, D * D>{}
                                           : without<D>(free, particle.normal);
    }
  }
  return held;
}

}  // namespace pliant::undeformed

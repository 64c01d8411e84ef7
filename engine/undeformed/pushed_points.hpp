#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "engine/undeformed/held_directions.hpp"
#include "engine/undeformed/moving_surface.hpp"

/// Points that move with the carriers of a surface, and impulses on them. Each carrier takes its
/// share of an impulse, so that no momentum is lost.
namespace pliant::undeformed {

/// Velocity and shift of a point from those of the carriers.
template <int D>
Pushed<D> carried_by(const std::vector<Pushed<D>>& carriers, std::span<const Share> shares) {
  Pushed<D> sum = {};
  for (const Share& share : shares) {
    const Pushed<D>& carrier = carriers[share.slot];
    for (int a = 0; a < D; ++a) sum.velocity[a] += share.weight * carrier.velocity[a];
    for (int a = 0; a < D; ++a) sum.shift[a] += share.weight * carrier.shift[a];
  }
  return sum;
}

/// Gives a point an impulse [N s], and moves it by the response to another one [kg m].
template <class T, int D>
void push_point(MovingSurface<T, D>& surface, std::span<const Share> shares,
                const Point<D>& impulse, const Point<D>& moved) {
  std::vector<Pushed<D>>& pushed = surface.pushed();
  for (const Share& share : shares) {
    const Carrier<D>& carrier = surface.carrier(share.slot);
    const double response = share.weight * carrier.inverse_mass;
    Pushed<D>& at = pushed[share.slot];
    const Point<D> velocity = carrier.is_free ? projected<D>(*carrier.is_free, impulse) : impulse;
    const Point<D> shift = carrier.is_free ? projected<D>(*carrier.is_free, moved) : moved;
    for (int a = 0; a < D; ++a) at.velocity[a] += response * velocity[a];
    for (int a = 0; a < D; ++a) at.shift[a] += response * shift[a];
  }
}

/// Velocity of a point for an impulse on it, without walls [1/kg].
template <class T, int D>
double compliance(const MovingSurface<T, D>& surface, std::span<const Share> shares) {
  double sum = 0;
  for (const Share& share : shares) {
    sum += share.weight * share.weight * surface.carrier(share.slot).inverse_mass;
  }
  return sum;
}

/// The same along the unit vector `n` for an impulse along it; walls hold carriers.
template <class T, int D>
double compliance_along(const MovingSurface<T, D>& surface, std::span<const Share> shares,
                        const Point<D>& n) {
  double sum = 0;
  for (const Share& share : shares) {
    const Carrier<D>& carrier = surface.carrier(share.slot);
    const double free = carrier.is_free ? dot<D>(n, projected<D>(*carrier.is_free, n)) : 1;
    sum += free * share.weight * share.weight * carrier.inverse_mass;
  }
  return sum;
}

/// Appends the shares of a point of a facet, whose corners have these weights there: each carrier
/// once, ascending.
template <class T, int D>
void append_shares(const MovingSurface<T, D>& surface, std::int32_t facet,
                   const std::array<double, D>& weight, std::vector<Share>& shares) {
  constexpr std::int32_t none = std::numeric_limits<std::int32_t>::max();
  std::array<std::span<const Share>, D> rest;
  for (int v = 0; v < D; ++v) {
    if (weight[v] != 0) rest[v] = surface.shares(surface.facet(facet)[v]);
  }
  for (;;) {
    std::int32_t next = none;
    for (const auto& of_corner : rest) {
      if (!of_corner.empty()) next = std::min(next, of_corner.front().slot);
    }
    if (next == none) return;
    double sum = 0;
    for (int v = 0; v < D; ++v) {
      if (rest[v].empty() || rest[v].front().slot != next) continue;
      sum += weight[v] * rest[v].front().weight;
      rest[v] = rest[v].subspan(1);
    }
    shares.push_back({next, sum});
  }
}

}  // namespace pliant::undeformed

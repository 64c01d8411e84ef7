#include "engine/undeformed/contact/wall_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>

#include "engine/lattice/point_algebra.hpp"

namespace pliant::undeformed {

namespace {

// In a step, the wall is in its place at the start, and x at the end.
template <int D>
Point<D> place_before(const MetWall<D>& wall, const Point<D>& x) {
  return difference<D>(x, wall.step.shift_at(x));
}

template <class T, int D>
double largest_speed(const std::vector<PushedSurface<T, D>>& surfaces) {
  double square = 0;
  for (const PushedSurface<T, D>& surface : surfaces) {
    for (const MovableCorner& corner : surface.outer_corners()) {
      const std::int32_t slot = surface.shape.shares(corner.number).front().slot;
      double of_carrier = 0;
      for (const auto& u : surface.body->velocity) of_carrier += double{u[slot]} * double{u[slot]};
      square = std::max(square, of_carrier);
    }
  }
  return std::sqrt(square);
}

/// How far the rotation of a wall moves its point at x in the step [m].
template <int D>
double shift_by_turn(const MetWall<D>& wall, const Point<D>& x) {
  const Point<D> by_turn = difference<D>(wall.step.shift_at(x), wall.step.shift);
  return std::sqrt(dot<D>(by_turn, by_turn));
}

/// The largest speed at which a wall that turns moves through the corners [m/s].
template <class T, int D>
double speed_by_turn(const std::vector<PushedSurface<T, D>>& surfaces, const MetWall<D>& wall) {
  double shift = 0;
  if (!wall.step.turns) return shift;
  for (const PushedSurface<T, D>& surface : surfaces) {
    for (const MovableCorner& corner : surface.outer_corners()) {
      shift = std::max(shift, shift_by_turn<D>(wall, surface.place(corner.number)));
    }
  }
  return shift / wall.length;
}

}  // namespace

template <class T, int D>
void WallSearch<T, D>::begin(const Surfaces& surfaces, const std::vector<MetWall<D>>& walls) {
  all_corners_.clear();
  for (const PushedSurface<T, D>& surface : surfaces) {
    auto& all = all_corners_.emplace_back(surface.corners.size());
    std::iota(all.begin(), all.end(), 0);
  }
  spared_.clear();
  state_.near_walls.clear();
  for (const MetWall<D>& wall : walls) {
    auto& spared = spared_.emplace_back();
    for (const PushedSurface<T, D>& surface : surfaces) spared.push_back(spared_by(wall, surface));
    NearWall& near = state_.near_walls.emplace_back();
    for (NearCorners* corners : {&near.soon, &near.later}) {
      for (const auto& all : all_corners_) corners->corners.emplace_back().reserve(all.size());
    }
  }
}

// An attached wall holds particles up to half a spacing away, so that corners nearer than that
// hardly move; corners on a slip wall stay on it.
template <class T, int D>
std::vector<bool> WallSearch<T, D>::spared_by(const MetWall<D>& met,
                                              const PushedSurface<T, D>& surface) const {
  constexpr double rounding = 1e-6;  // [spacings]
  std::vector<bool> spared(surface.corners.size());
  const Wall<D>& wall = state_.boundaries.walls[met.number];
  if (!wall.is_attached()) return spared;
  for (std::size_t i = 0; i < spared.size(); ++i) {
    const Point<D>& x = surface.shape.start[surface.corners[i].number];
    spared[i] = wall.distance(x) < (0.5 + rounding) * spacing_;
  }
  return spared;
}

template <class T, int D>
void WallSearch<T, D>::update(const Surfaces& surfaces, const std::vector<MetWall<D>>& walls) {
  std::optional<double> speed;
  for (std::size_t w = 0; w < walls.size(); ++w) {
    const MetWall<D>& wall = walls[w];
    NearWall& near = state_.near_walls[w];
    const double approach =
        wall.length * near.speed + std::sqrt(dot<D>(wall.step.shift, wall.step.shift));
    near.soon.unspent -= approach;
    near.later.unspent -= approach;
    if (near.soon.unspent > 0) continue;
    if (!speed) speed = largest_speed(surfaces);
    search(w, surfaces, wall, *speed);
  }
}

// A larger reach makes lists longer and searches rarer.
template <class T, int D>
void WallSearch<T, D>::search(std::size_t w, const Surfaces& surfaces, const MetWall<D>& wall,
                              double speed) {
  constexpr double least_reach = 0.25;  // [spacings]
  constexpr double slow_steps = 32;     // until the next search if nothing moves
  constexpr double fast_steps = 8;      // at least
  constexpr double acceleration = 2;    // ratio of the bound on the speed to the present speed
  constexpr double later = 8;           // ratio of the reaches of the two lists
  constexpr double margin = 2;          // of the longer list, for corners that accelerate faster
  NearWall& near = state_.near_walls[w];
  const double least = least_reach * spacing_;
  near.speed = std::max(acceleration * (speed + speed_by_turn(surfaces, wall)),
                        least / (slow_steps * wall.length));
  const double reach = std::max(least, fast_steps * wall.length * near.speed);
  if (margin * reach > near.later.unspent) {
    list(w, surfaces, wall, later * reach, all_corners_, near.later);
  }
  list(w, surfaces, wall, reach, near.later.corners, near.soon);
}

template <class T, int D>
void WallSearch<T, D>::list(std::size_t w, const Surfaces& surfaces, const MetWall<D>& wall,
                            double reach, const std::vector<std::vector<std::int32_t>>& among,
                            NearCorners& near) const {
  near.unspent = reach;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    const PushedSurface<T, D>& surface = surfaces[s];
    std::vector<std::int32_t>& listed = near.corners[s];
    bool is_near = !listed.empty();
    listed.clear();
    const auto add_near_ones = [&](auto first, auto last) {
      std::copy_if(first, last, std::back_inserter(listed), [&](std::int32_t i) {
        const std::int32_t corner = surface.corners[i].number;
        const double around = reach_of_facets(wall.face, surface.half_edge(corner));
        return !spared_[w][s][i] && may_touch(surface, corner, wall, reach + around);
      });
    };
    const auto inner = std::lower_bound(among[s].begin(), among[s].end(),
                                        static_cast<int>(surface.outer_corners().size()));
    add_near_ones(among[s].begin(), inner);
    is_near = is_near || !listed.empty();
    if (is_near && !state_.boundaries.walls[wall.number].is_attached()) {
      add_near_ones(inner, among[s].end());
    }
  }
}

// The distance from a tool of several shapes costs as much as all forces on a node.
template <class T, int D>
bool WallSearch<T, D>::may_reach(const MetWall<D>& wall, const Point<D>& x, double reach) const {
  const Point<D>& offset = state_.boundaries.walls[wall.number].pose().offset;
  for (int a = 0; a < D; ++a) {
    const double at = x[a] - offset[a];
    if (at < wall.box.lower[a] - reach || at > wall.box.upper[a] + reach) return false;
  }
  return true;
}

// A corner with many carriers is near its first one.
template <class T, int D>
bool WallSearch<T, D>::may_touch(const PushedSurface<T, D>& surface, std::int32_t corner,
                                 const MetWall<D>& wall, double reach) const {
  const ContactSurface<D>& shape = surface.shape;
  const std::span<const Share> shares = shape.shares(corner);
  Point<D> x = shape.start[corner];
  if (shares.size() <= 2) {
    x = surface.place(corner);
  } else {
    for (int a = 0; a < D; ++a) x[a] += (surface.body->*surface.moved)[a][shares.front().slot];
    reach += shape.reach[corner];
  }
  x = place_before<D>(wall, x);
  return may_reach(wall, x, reach) && state_.boundaries.walls[wall.number].distance(x) < reach;
}

template class WallSearch<double, 2>;
template class WallSearch<double, 3>;
template class WallSearch<float, 2>;
template class WallSearch<float, 3>;

}  // namespace pliant::undeformed

#include "engine/undeformed/contact/wall_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "engine/geometry/signed_distance.hpp"
#include "engine/lattice/point_algebra.hpp"

namespace pliant::undeformed {

namespace {

// Corners share particles, so a push may press a neighbour into the wall again, or out of it.
constexpr int most_sweeps = 8;
constexpr double settled = 1e-3;           // of the largest change in a sweep
constexpr double least_compliance = 1e-3;  // along the normal, relative to other directions

Box<3> without_end() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};
}

}  // namespace

template <class T, int D>
WallContact<T, D>::WallContact(State<D>& state, const Case& settings, Displacements<T, D> moved)
    : state_(state), moved_(moved), search_(state, settings.discretisation.spacing) {
  for (std::size_t b = 0; b < settings.boundaries.size(); ++b) {
    const BoundaryCase& boundary = settings.boundaries[b];
    const int number = state_.boundaries.wall_of[b];
    if (number < 0) continue;
    MetWall<D>& wall = walls_.emplace_back();
    wall.number = number;
    wall.source = &boundary;
    wall.friction = state_.boundaries.walls[number].friction();
    wall.box = boundary.rotation ? without_end() : bounding_box(boundary.geometry);
    is_expected_ = is_expected_ || !state_.boundaries.walls[number].is_attached();
  }
}

template <class T, int D>
void WallContact<T, D>::apply(double time, double kick, double length, double drift) {
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    MetWall<D>& wall = walls_[w];
    wall.step = state_.boundaries.walls[wall.number].step(time, length);
    wall.inertia = state_.clock.inertia(kick);
    wall.kick = kick;
    wall.length = length;
    wall.drift = drift;
  }
  search_.update(surfaces_, walls_);
  pushed_.clear();
  for (std::size_t s = 0; s < surfaces_.size(); ++s) push_out(s);
}

template <class T, int D>
void WallContact<T, D>::push_out(std::size_t s) {
  PushedSurface<T, D>& surface = surfaces_[s];
  const std::size_t outer = surface.outer_corners().size();
  std::size_t near = 0;
  for (std::size_t w = 0; w < walls_.size(); ++w)
    near += state_.near_walls[w].soon.corners[s].size();
  given_.assign(near, {});
  double first = 0;
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    double change = 0;
    auto given = given_.begin();
    for (std::size_t w = 0; w < walls_.size(); ++w) {
      for (const std::int32_t corner : state_.near_walls[w].soon.corners[s]) {
        const double moved = push(surface, surface.corners[corner], walls_[w], *given++);
        change = std::max(change, moved);
        if (moved > 0 && static_cast<std::size_t>(corner) >= outer) {
          state_.tool_inside = walls_[w].source;
        }
      }
    }
    first = std::max(first, change);
    if (change <= settled * first) break;
  }
  conclude(s);
}

template <class T, int D>
void WallContact<T, D>::conclude(std::size_t s) {
  const PushedSurface<T, D>& surface = surfaces_[s];
  auto given = given_.begin();
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    for (const std::int32_t number : state_.near_walls[w].soon.corners[s]) {
      const MovableCorner& corner = surface.corners[number];
      add_friction(surface, corner, walls_[w], *given);
      const bool is_pushed = given->impulse > 0 || given->moved > 0;
      ++given;
      if (is_expected_ || !is_pushed) continue;
      for (const Share& share : surface.carriers_of(corner)) {
        pushed_.push_back({static_cast<int>(s), share.slot});
      }
    }
  }
}

template <class T, int D>
double WallContact<T, D>::push(PushedSurface<T, D>& surface, const MovableCorner& corner,
                               const MetWall<D>& met, Given& given) {
  const bool has_met = given.impulse > 0 || given.moved > 0;
  if (!has_met && surface.shape.shares(corner.number).size() > 2 &&
      !search_.may_touch(surface, corner.number, met, 0)) {
    return 0;
  }
  Body<T, D>& body = *surface.body;
  const Wall<D>& wall = state_.boundaries.walls[met.number];
  Point<D> x = surface.place(corner.number);
  // The wall is in its place at the start of the step.
  Point<D> velocity = met.step.shift_at(x);
  x = difference<D>(x, velocity);
  if (!has_met && !search_.may_reach(met, x, 0)) return 0;
  for (double& component : velocity) component /= met.length;
  const double gap = wall.distance(x);
  if (!has_met && gap >= 0) return 0;
  const Point<D> n = wall.normal(x);
  const std::span<const Share> bearing = surface.carriers_of(corner);
  BodyCarriers<T, D> carriers(body, body.*moved_, surface.held, met.inertia / met.kick);
  const double along = compliance<D>(carriers, bearing, n);
  if (along < least_compliance * corner.compliance) return 0;
  const Point<D> slip = difference<D>(carried<T, D>(body.velocity, bearing), velocity);
  const double normal_speed = dot<D>(slip, n);
  const bool in_middle = met.drift == met.length;
  const double impulse_now =
      std::max((in_middle ? -gap / met.length : -normal_speed) / along, -given.impulse);
  const double moved_now = std::max(-gap / along, -given.moved);
  given.impulse += impulse_now;
  given.moved += moved_now;
  const Point<D> before = given.friction;
  Point<D> sliding;
  for (int a = 0; a < D; ++a) {
    sliding[a] = slip[a] - normal_speed * n[a];
    given.friction[a] -= sliding[a] / along;
  }
  const double size = std::sqrt(dot<D>(given.friction, given.friction));
  const double most = given.impulse > 0 ? met.friction * given.impulse : 0;
  if (size > most) {
    for (double& component : given.friction) component *= most / size;
  }
  Point<D> impulse, moved, on_body;
  for (int a = 0; a < D; ++a) {
    const double friction = given.friction[a] - before[a];
    impulse[a] = impulse_now * n[a] + friction;
    moved[a] = moved_now * n[a] + met.drift * friction;
    on_body[a] = met.inertia * impulse[a];
    state_.energy.wall_work += on_body[a] * velocity[a];
    state_.power.wall_work += on_body[a] / met.kick * velocity[a];
  }
  Wrench<D> on_wall;
  on_wall.add(x, on_body);
  state_.wall_impulse[met.number].add(on_wall, 1);
  state_.wall_force[met.number].add(on_wall, 1 / met.kick);
  push_point<D>(carriers, bearing, impulse, moved);
  return along * std::max(met.length * std::sqrt(dot<D>(impulse, impulse)), std::abs(moved_now));
}

// Loss by friction (PB.41). A sweep takes back what an earlier one has pushed too far: neither
// alone does work.
template <class T, int D>
void WallContact<T, D>::add_friction(const PushedSurface<T, D>& surface,
                                     const MovableCorner& corner, const MetWall<D>& met,
                                     const Given& given) {
  if (given.friction == Point<D>{}) return;
  Point<D> velocity = met.step.shift_at(surface.place(corner.number));
  for (double& component : velocity) component /= met.length;
  const std::span<const Share> bearing = surface.carriers_of(corner);
  const Point<D> slip = difference<D>(carried<T, D>(surface.body->velocity, bearing), velocity);
  const double lost = -met.inertia * dot<D>(given.friction, slip);
  state_.energy.friction += lost;
  state_.power.friction += lost / met.kick;
}

template class WallContact<double, 2>;
template class WallContact<double, 3>;
template class WallContact<float, 2>;
template class WallContact<float, 3>;

}  // namespace pliant::undeformed

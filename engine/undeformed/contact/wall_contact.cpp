#include "engine/undeformed/contact/wall_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "engine/geometry/signed_distance.hpp"
#include "engine/lattice/point_algebra.hpp"

namespace pliant::undeformed {

namespace {

// Corners share particles, so a push may press a neighbour into the wall again. The error that
// Gauss-Seidel sweeps leave in (TL.12) is a small share of the motion in a step.
constexpr int sweeps = 4;
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
    wall.inertia = state_.clock.mass_scaling * (1 + state_.clock.damping * kick / 2);
    wall.kick = kick;
    wall.length = length;
    wall.drift = drift;
    search_.update(w, surfaces_, wall);
  }
  for (std::size_t s = 0; s < surfaces_.size(); ++s) {
    bool any_inside = true;
    for (int sweep = 0; sweep < sweeps && any_inside; ++sweep) {
      any_inside = false;
      for (std::size_t w = 0; w < walls_.size(); ++w) {
        for (const std::int32_t corner : state_.near_walls[w].corners[s]) {
          if (!push(surfaces_[s], surfaces_[s].corners[corner], walls_[w])) continue;
          any_inside = true;
          if (static_cast<std::size_t>(corner) >= surfaces_[s].outer_corners().size()) {
            state_.tool_inside = walls_[w].source;
          }
        }
      }
    }
  }
}

template <class T, int D>
bool WallContact<T, D>::push(PushedSurface<T, D>& surface, const MovableCorner& corner,
                             const MetWall<D>& met) {
  if (surface.shape.shares(corner.number).size() > 2 &&
      !search_.may_touch(surface, corner.number, met, 0)) {
    return false;
  }
  Body<T, D>& body = *surface.body;
  const Wall<D>& wall = state_.boundaries.walls[met.number];
  Point<D> x = surface.place(corner.number);
  // The wall is in its place at the start of the step.
  Point<D> velocity = met.step.shift_at(x);
  x = difference<D>(x, velocity);
  if (!search_.may_reach(met, x, 0)) return false;
  for (double& component : velocity) component /= met.length;
  const double gap = wall.distance(x);
  if (gap >= 0) return false;
  const Point<D> n = wall.normal(x);
  const std::span<const Share> bearing = surface.carriers_of(corner);
  BodyCarriers<T, D> carriers(body, body.*moved_, surface.held);
  const double along = compliance<D>(carriers, bearing, n);
  if (along < least_compliance * corner.compliance) return false;
  Point<D> slip = carried<T, D>(body.velocity, bearing);
  double normal_speed = 0, square = 0;
  for (int a = 0; a < D; ++a) {
    slip[a] -= velocity[a];
    normal_speed += slip[a] * n[a];
  }
  for (int a = 0; a < D; ++a) {
    slip[a] -= normal_speed * n[a];
    square += slip[a] * slip[a];
  }
  const bool in_middle = met.drift == met.length;
  const double pushed = in_middle ? -gap / met.length : std::max(-normal_speed, 0.);
  const double speed = std::sqrt(square);
  const double most = met.friction > 0 ? met.friction * pushed : 0;
  const double taken = speed > most ? most / speed : 1;  // share of the slip that friction takes
  Point<D> impulse, moved, on_body;
  for (int a = 0; a < D; ++a) {
    impulse[a] = (pushed * n[a] - taken * slip[a]) / along;
    moved[a] = (-gap * n[a] - met.drift * taken * slip[a]) / along;
    on_body[a] = met.inertia * impulse[a];
    state_.energy.wall_work += on_body[a] * velocity[a];
    state_.power.wall_work += on_body[a] / met.kick * velocity[a];
  }
  Wrench<D> given;
  given.add(x, on_body);
  state_.wall_impulse[met.number].add(given, 1);
  state_.wall_force[met.number].add(given, 1 / met.kick);
  // Loss by friction (PB.41).
  const double lost = met.inertia * taken * (1 - taken) * square / along;
  state_.energy.friction += lost;
  state_.power.friction += lost / met.kick;
  push_point<D>(carriers, bearing, impulse, moved);
  return true;
}

template class WallContact<double, 2>;
template class WallContact<double, 3>;
template class WallContact<float, 2>;
template class WallContact<float, 3>;

}  // namespace pliant::undeformed

#include "engine/undeformed/contact/wall_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

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
    : state_(state), moved_(moved) {
  for (std::size_t b = 0; b < settings.boundaries.size(); ++b) {
    const BoundaryCase& boundary = settings.boundaries[b];
    if (boundary.kind != BoundaryCase::Kind::contact_wall) continue;
    const int wall = state_.boundaries.wall_of[b];
    const double friction = state_.boundaries.walls[wall].friction();
    const bool turns = boundary.rotation.has_value();
    walls_.push_back({wall,
                      friction == 0,
                      friction,
                      {},
                      1,
                      1,
                      1,
                      1,
                      turns ? without_end() : bounding_box(boundary.geometry)});
  }
}

template <class T, int D>
void WallContact<T, D>::add_surface(Body<T, D>& body, ContactSurface<D> shape,
                                    ImpulseCarriers bearing) {
  Surface& surface = surfaces_.emplace_back();
  surface.body = &body;
  surface.held = held_directions(body);
  surface.shape = std::move(shape);
  surface.impulse_carriers = bearing;
  const BodyCarriers<T, D> carriers(body, body.*moved_, surface.held);
  for (std::int32_t number = 0; number < surface.shape.corners(); ++number) {
    Corner corner{number, {surface.shape.shares(number).front().slot, 1}, 0};
    for (int a = 0; a < D; ++a) {
      Point<D> axis = {};
      axis[a] = 1;
      const double along = compliance<D>(carriers, impulse_carriers(surface, corner), axis);
      corner.compliance = std::max(corner.compliance, along);
    }
    if (corner.compliance > 0) surface.corners.push_back(corner);
  }
}

template <class T, int D>
std::span<const Share> WallContact<T, D>::impulse_carriers(const Surface& surface,
                                                           const Corner& corner) {
  if (surface.impulse_carriers == ImpulseCarriers::first) return {&corner.first, 1};
  return surface.shape.shares(corner.number);
}

template <class T, int D>
void WallContact<T, D>::apply(double time, double kick, double length, double drift) {
  for (ContactWall& wall : walls_) {
    wall.step = state_.boundaries.walls[wall.wall].step(time, length);
    wall.inertia = state_.clock.mass_scaling * (1 + state_.clock.damping * kick / 2);
    wall.kick = kick;
    wall.length = length;
    wall.drift = drift;
  }
  for (Surface& surface : surfaces_) {
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      for (const ContactWall& wall : walls_) {
        for (const Corner& corner : surface.corners) push(surface, corner, wall);
      }
    }
  }
}

// The distance from a tool of several shapes costs as much as all forces on a node.
template <class T, int D>
bool WallContact<T, D>::is_outside_box(const ContactWall& contact, const Point<D>& x) const {
  const Point<D>& offset = state_.boundaries.walls[contact.wall].pose().offset;
  for (int a = 0; a < D; ++a) {
    const double at = x[a] - offset[a];
    if (at < contact.box.lower[a] || at > contact.box.upper[a]) return true;
  }
  return false;
}

// A cheap test that excludes most corners, which are far from the wall.
template <class T, int D>
bool WallContact<T, D>::may_touch(const Surface& surface, std::int32_t corner,
                                  const ContactWall& contact) const {
  const ContactSurface<D>& shape = surface.shape;
  const std::int32_t first = shape.share[shape.first_share[corner]].slot;
  Point<D> x = shape.start[corner];
  for (int a = 0; a < D; ++a) x[a] += (surface.body->*moved_)[a][first];
  const Wall<D>& wall = state_.boundaries.walls[contact.wall];
  return wall.distance(difference<D>(x, contact.step.shift_at(x))) < shape.reach[corner];
}

template <class T, int D>
void WallContact<T, D>::push(Surface& surface, const Corner& corner, const ContactWall& contact) {
  Body<T, D>& body = *surface.body;
  const ContactSurface<D>& shape = surface.shape;
  const std::span<const Share> shares = shape.shares(corner.number);
  if (shares.size() > 2 && !may_touch(surface, corner.number, contact)) return;
  const Wall<D>& wall = state_.boundaries.walls[contact.wall];
  Point<D> x = carried<T, D>(body.*moved_, shares);
  for (int a = 0; a < D; ++a) x[a] += shape.start[corner.number][a];
  // The wall is in its place at the start of the step.
  Point<D> velocity = contact.step.shift_at(x);
  x = difference<D>(x, velocity);
  if (is_outside_box(contact, x)) return;
  for (double& component : velocity) component /= contact.length;
  const double gap = wall.distance(x);
  if (gap >= 0) return;
  const Point<D> n = wall.normal(x);
  const std::span<const Share> bearing = impulse_carriers(surface, corner);
  BodyCarriers<T, D> carriers(body, body.*moved_, surface.held);
  const double along = compliance<D>(carriers, bearing, n);
  if (along < least_compliance * corner.compliance) return;
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
  const bool in_middle = contact.drift == contact.length;
  const double pushed = in_middle ? -gap / contact.length : std::max(-normal_speed, 0.);
  const double speed = std::sqrt(square);
  const double most = contact.slides ? 0 : contact.friction * pushed;
  const double taken = speed > most ? most / speed : 1;  // share of the slip that friction takes
  Point<D> impulse, moved, on_body;
  for (int a = 0; a < D; ++a) {
    impulse[a] = (pushed * n[a] - taken * slip[a]) / along;
    moved[a] = (-gap * n[a] - contact.drift * taken * slip[a]) / along;
    on_body[a] = contact.inertia * impulse[a];
    state_.energy.wall_work += on_body[a] * velocity[a];
    state_.power.wall_work += on_body[a] / contact.kick * velocity[a];
  }
  Wrench<D> given;
  given.add(x, on_body);
  state_.wall_impulse[contact.wall].add(given, 1);
  state_.wall_force[contact.wall].add(given, 1 / contact.kick);
  // Loss by friction (PB.41).
  const double lost = contact.inertia * taken * (1 - taken) * square / along;
  state_.energy.friction += lost;
  state_.power.friction += lost / contact.kick;
  push_point<D>(carriers, bearing, impulse, moved);
}

template class WallContact<double, 2>;
template class WallContact<double, 3>;
template class WallContact<float, 2>;
template class WallContact<float, 3>;

}  // namespace pliant::undeformed

#include "engine/undeformed/contact/wall_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "engine/geometry/is_round.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/lattice/point_algebra.hpp"
#include "engine/undeformed/contact/held_back.hpp"

namespace pliant::undeformed {

namespace {

Box<3> without_end() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};
}

Face face_of(const Shape& shape, double spacing) {
  constexpr double least_radius = 2;  // of a smooth tool [spacings]
  if (shape.kind == Shape::Kind::half_space) return Face::plane;
  return is_round(shape) && shape.radius >= least_radius * spacing ? Face::smooth : Face::sharp;
}

}  // namespace

template <class T, int D>
WallContact<T, D>::WallContact(State<D>& state, const Case& settings, Displacements<T, D> moved)
    : state_(state),
      moved_(moved),
      search_(state, settings.discretisation.spacing),
      meetings_(settings.discretisation.spacing) {
  for (std::size_t b = 0; b < settings.boundaries.size(); ++b) {
    const BoundaryCase& boundary = settings.boundaries[b];
    const int number = state_.boundaries.wall_of[b];
    if (number < 0) continue;
    MetWall<D>& wall = walls_.emplace_back();
    wall.number = number;
    wall.source = &boundary;
    wall.friction = state_.boundaries.walls[number].friction();
    wall.box = boundary.rotation ? without_end() : bounding_box(boundary.geometry);
    const bool is_attached = state_.boundaries.walls[number].is_attached();
    is_expected_ = is_expected_ || !is_attached;
    wall.face =
        is_attached ? Face::plane : face_of(boundary.geometry, settings.discretisation.spacing);
    has_tools_ = has_tools_ || wall.face != Face::plane;
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
  // Corners share particles, so a push may press a neighbour into the wall again, or out of it.
  constexpr int most_sweeps = 32;
  constexpr double settled = 1e-3;  // of the largest change in a sweep
  PushedSurface<T, D>& surface = surfaces_[s];
  meetings_.clear();
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    meetings_.add(surface, state_.near_walls[w].soon.corners[s],
                  state_.boundaries.walls[walls_[w].number], walls_[w], search_);
  }
  double first = 0;
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    double change = 0;
    for (std::size_t w = 0; w < walls_.size(); ++w) {
      for (WallMeeting<D>& meeting : meetings_.of_wall(w)) {
        change = std::max(change, push(surface, walls_[w], meeting));
      }
    }
    first = std::max(first, change);
    if (change <= settled * first) break;
  }
  conclude(s);
}

template <class T, int D>
void WallContact<T, D>::conclude(std::size_t s) {
  constexpr double large_share = 0.25;  // of a push, on particles inside the body
  const PushedSurface<T, D>& surface = surfaces_[s];
  const std::size_t outer = surface.outer_corners().size();
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    double inside = 0, all = 0;
    for (const WallMeeting<D>& meeting : meetings_.of_wall(w)) {
      all += meeting.moved;
      if (static_cast<std::size_t>(meeting.corner) >= outer) inside += meeting.moved;
    }
    if (inside > large_share * all) state_.tool_inside = walls_[w].source;
    for (const WallMeeting<D>& meeting : meetings_.of_wall(w)) {
      add_friction(surface, walls_[w], meeting);
      if (is_expected_ || !meeting.is_pushed()) continue;
      for (const Share& share : meetings_.bearing_of(meeting)) {
        pushed_.push_back({static_cast<int>(s), share.slot});
      }
    }
  }
}

template <class T, int D>
double WallContact<T, D>::push(PushedSurface<T, D>& surface, const MetWall<D>& met,
                               WallMeeting<D>& meeting) {
  Body<T, D>& body = *surface.body;
  const std::span<const Share> bearing = meetings_.bearing_of(meeting);
  const Point<D>& n = meeting.normal;
  const Point<D> displacement = carried<T, D>(body.*moved_, bearing);
  const double gap = meeting.offset + dot<D>(n, displacement);
  if (!meeting.is_pushed() && gap >= 0) return 0;
  BodyCarriers<T, D> carriers(body, body.*moved_, surface.held, met.inertia / met.kick);
  const double along = meeting.compliance;
  const Point<D> velocity = carried<T, D>(body.velocity, bearing);
  const Point<D> slip = difference<D>(velocity, meeting.velocity);
  const bool in_middle = met.drift == met.length;
  const double impulse_now =
      std::max((in_middle ? -gap / met.length : -dot<D>(slip, n)) / along, -meeting.impulse);
  const double moved_now = std::max(-gap / along, -meeting.moved);
  meeting.impulse += impulse_now;
  meeting.moved += moved_now;
  Point<D> stray;
  for (int a = 0; a < D; ++a) {
    stray[a] = displacement[a] - met.drift * velocity[a] - meeting.before[a];
  }
  const Point<D> friction =
      held_back<D>(meeting.friction, slip, n, along, met.friction, meeting.impulse);
  const Point<D> held = held_back<D>(meeting.held, stray, n, along, met.friction, meeting.moved);
  Point<D> impulse, moved;
  for (int a = 0; a < D; ++a) {
    const double friction_now = friction[a] - meeting.friction[a];
    impulse[a] = impulse_now * n[a] + friction_now;
    moved[a] = moved_now * n[a] + met.drift * friction_now + held[a] - meeting.held[a];
  }
  meeting.friction = friction;
  meeting.held = held;
  add_push(met, meeting, impulse);
  push_point<D>(carriers, bearing, impulse, moved);
  return along * std::max(met.length * norm<D>(impulse), norm<D>(moved));
}

template <class T, int D>
void WallContact<T, D>::add_push(const MetWall<D>& met, const WallMeeting<D>& meeting,
                                 const Point<D>& impulse) {
  Point<D> on_body;
  for (int a = 0; a < D; ++a) {
    on_body[a] = met.inertia * impulse[a];
    state_.energy.wall_work += on_body[a] * meeting.velocity[a];
    state_.power.wall_work += on_body[a] / met.kick * meeting.velocity[a];
  }
  Wrench<D> on_wall;
  on_wall.add(meeting.place, on_body);
  state_.wall_impulse[met.number].add(on_wall, 1);
  state_.wall_force[met.number].add(on_wall, 1 / met.kick);
}

// Loss by friction (PB.41). A sweep takes back what an earlier one has pushed too far: neither
// alone does work.
template <class T, int D>
void WallContact<T, D>::add_friction(const PushedSurface<T, D>& surface, const MetWall<D>& met,
                                     const WallMeeting<D>& meeting) {
  if (meeting.friction == Point<D>{}) return;
  const std::span<const Share> bearing = meetings_.bearing_of(meeting);
  const Point<D> slip =
      difference<D>(carried<T, D>(surface.body->velocity, bearing), meeting.velocity);
  const double lost = -met.inertia * dot<D>(meeting.friction, slip);
  state_.energy.friction += lost;
  state_.power.friction += lost / met.kick;
}

template class WallContact<double, 2>;
template class WallContact<double, 3>;
template class WallContact<float, 2>;
template class WallContact<float, 3>;

}  // namespace pliant::undeformed

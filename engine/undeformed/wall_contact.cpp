#include "engine/undeformed/wall_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include "engine/case/contact_laws.hpp"

namespace pliant::undeformed {

namespace {

// Corners share particles, so that one push may press a neighbour in again: (TL.12) of all of them
// is solved by Gauss-Seidel sweeps. What these leave is a small share of one step's motion.
constexpr int sweeps = 4;

double coefficient(const BoundaryCase& boundary) {
  if (row_of(boundary.friction).slides) return 0;
  return boundary.friction_coefficient.value_or(std::numeric_limits<double>::infinity());
}

}  // namespace

template <class T, int D>
WallContact<T, D>::WallContact(State<D>& state, const Case& settings) : state_(state) {
  for (std::size_t b = 0; b < settings.boundaries.size(); ++b) {
    const BoundaryCase& boundary = settings.boundaries[b];
    if (boundary.kind != BoundaryCase::Kind::contact_wall) continue;
    const double friction = coefficient(boundary);
    walls_.push_back({state_.boundaries.wall_of[b], friction == 0, friction, {}, {}, 1, 1, 1, 1});
  }
}

template <class T, int D>
void WallContact<T, D>::add_surface(Body<T, D>& body, const std::vector<Vertex<D>>& corners) {
  Surface& surface = surfaces_.emplace_back(Surface{&body, {}});
  std::set<std::int32_t> held;
  for (const auto& of_block : body.held) {
    for (const ConstrainedParticle<D>& particle : of_block) held.insert(particle.slot);
  }
  const auto inverse_mass = [&](std::int32_t slot) {
    return held.contains(slot) ? 0. : static_cast<double>(body.inverse_mass[slot]);
  };
  std::set<std::tuple<std::int32_t, std::int32_t, Point<D>>> known;
  for (const Vertex<D>& v : corners) {
    if (!known.insert({v.first, v.second, v.start}).second) continue;
    Corner corner{v, 0, (1 - v.along) * inverse_mass(v.first), v.along * inverse_mass(v.second)};
    if (v.first == v.second) corner = {v, 0, inverse_mass(v.first), 0};
    corner.compliance = v.first == v.second ? corner.first_response
                                            : (1 - v.along) * corner.first_response +
                                                  v.along * corner.second_response;
    if (corner.compliance > 0) surface.corners.push_back(corner);
  }
}

template <class T, int D>
void WallContact<T, D>::apply(double time, double kick, double length, double drift) {
  for (ContactWall& wall : walls_) {
    wall.velocity = state_.boundaries.walls[wall.wall].velocity(time + length / 2);
    for (int a = 0; a < D; ++a) wall.shift[a] = length * wall.velocity[a];
    wall.inertia = state_.clock.mass_scaling * (1 + state_.clock.damping * kick / 2);
    wall.kick = kick;
    wall.length = length;
    wall.drift = drift;
  }
  for (Surface& surface : surfaces_) {
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      for (const ContactWall& wall : walls_) {
        for (const Corner& corner : surface.corners) push(*surface.body, corner, wall);
      }
    }
  }
}

template <class T, int D>
void WallContact<T, D>::push(Body<T, D>& body, const Corner& corner, const ContactWall& contact) {
  const Wall<D>& wall = state_.boundaries.walls[contact.wall];
  const Vertex<D>& v = corner.vertex;
  // The wall is where it was at the start of the step.
  Point<D> x = body.position(v);
  for (int a = 0; a < D; ++a) x[a] -= contact.shift[a];
  const double gap = wall.distance(x);
  if (gap >= 0) return;
  const Point<D> n = wall.normal(x);
  Point<D> slip;
  double normal_speed = 0, square = 0;
  for (int a = 0; a < D; ++a) {
    slip[a] = (1 - v.along) * body.velocity[a][v.first] + v.along * body.velocity[a][v.second] -
              contact.velocity[a];
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
  const double taken = speed > most ? most / speed : 1;  // of the slip, by friction
  for (int a = 0; a < D; ++a) {
    const double impulse = (pushed * n[a] - taken * slip[a]) / corner.compliance;
    body.velocity[a][v.first] += static_cast<T>(corner.first_response * impulse);
    const double moved = (-gap * n[a] - contact.drift * taken * slip[a]) / corner.compliance;
    body.displacement[a][v.first] += static_cast<T>(corner.first_response * moved);
    if (v.second != v.first) {
      body.velocity[a][v.second] += static_cast<T>(corner.second_response * impulse);
      body.displacement[a][v.second] += static_cast<T>(corner.second_response * moved);
    }
    const double given = contact.inertia * impulse, force = given / contact.kick;
    state_.wall_impulse[contact.wall][a] += given;
    state_.wall_force[contact.wall][a] += force;
    state_.energy.wall_work += given * contact.velocity[a];
    state_.power.wall_work += force * contact.velocity[a];
  }
}

template class WallContact<double, 2>;
template class WallContact<double, 3>;
template class WallContact<float, 2>;
template class WallContact<float, 3>;

}  // namespace pliant::undeformed

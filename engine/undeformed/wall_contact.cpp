#include "engine/undeformed/wall_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include "engine/undeformed/held_directions.hpp"

namespace pliant::undeformed {

namespace {

// Corners share particles, so that one push may press a neighbour in again: (TL.12) of all of them
// is solved by Gauss-Seidel sweeps. What these leave is a small share of one step's motion.
constexpr int sweeps = 4;
constexpr double least_compliance = 1e-3;  // along the normal, of what a corner has elsewhere

}  // namespace

template <class T, int D>
WallContact<T, D>::WallContact(State<D>& state, const Case& settings, Displacements<T, D> moved)
    : state_(state), moved_(moved) {
  for (std::size_t b = 0; b < settings.boundaries.size(); ++b) {
    const BoundaryCase& boundary = settings.boundaries[b];
    if (boundary.kind != BoundaryCase::Kind::contact_wall) continue;
    const int wall = state_.boundaries.wall_of[b];
    const double friction = state_.boundaries.walls[wall].friction();
    walls_.push_back({wall, friction == 0, friction, {}, {}, 1, 1, 1, 1});
  }
}

template <class T, int D>
void WallContact<T, D>::add_surface(Body<T, D>& body, const std::vector<Vertex<D>>& corners) {
  Surface& surface = surfaces_.emplace_back(Surface{&body, {}});
  const HeldDirections<D> held = held_directions(body);
  const auto response = [&](std::int32_t slot, double weight) {
    const auto at = held.find(slot);
    Tensor tensor = at == held.end() ? all_directions<D>() : at->second;
    for (double& component : tensor) component *= weight * body.inverse_mass[slot];
    return tensor;
  };
  std::set<std::tuple<std::int32_t, std::int32_t, Point<D>>> known;
  for (const Vertex<D>& v : corners) {
    if (!known.insert({v.first, v.second, v.start}).second) continue;
    Corner corner{v, response(v.first, 1), {}, {}};
    corner.compliance = corner.first_response;
    if (v.first != v.second) {
      corner.first_response = response(v.first, 1 - v.along);
      corner.second_response = response(v.second, v.along);
      for (int c = 0; c < D * D; ++c) {
        corner.compliance[c] =
            (1 - v.along) * corner.first_response[c] + v.along * corner.second_response[c];
      }
    }
    if (corner.compliance != Tensor{}) surface.corners.push_back(corner);
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
  Point<D> x = body.position(v, body.*moved_);
  for (int a = 0; a < D; ++a) x[a] -= contact.shift[a];
  const double gap = wall.distance(x);
  if (gap >= 0) return;
  const Point<D> n = wall.normal(x);
  double compliance = 0, largest = 0;
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) compliance += n[i] * corner.compliance[D * i + j] * n[j];
    largest = std::max(largest, corner.compliance[(D + 1) * i]);
  }
  if (compliance < least_compliance * largest) return;
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
  Point<D> impulse, moved;
  for (int a = 0; a < D; ++a) {
    impulse[a] = (pushed * n[a] - taken * slip[a]) / compliance;
    moved[a] = (-gap * n[a] - contact.drift * taken * slip[a]) / compliance;
    const double given = contact.inertia * impulse[a], force = given / contact.kick;
    state_.wall_impulse[contact.wall][a] += given;
    state_.wall_force[contact.wall][a] += force;
    state_.energy.wall_work += given * contact.velocity[a];
    state_.power.wall_work += force * contact.velocity[a];
  }
  move(body, v.first, corner.first_response, impulse, moved);
  if (v.second != v.first) move(body, v.second, corner.second_response, impulse, moved);
}

template <class T, int D>
void WallContact<T, D>::move(Body<T, D>& body, std::int32_t slot, const Tensor& response,
                             const Point<D>& impulse, const Point<D>& moved) {
  for (int i = 0; i < D; ++i) {
    double velocity = 0, displacement = 0;
    for (int j = 0; j < D; ++j) {
      velocity += response[D * i + j] * impulse[j];
      displacement += response[D * i + j] * moved[j];
    }
    body.velocity[i][slot] += static_cast<T>(velocity);
    (body.*moved_)[i][slot] += static_cast<T>(displacement);
  }
}

template class WallContact<double, 2>;
template class WallContact<double, 3>;
template class WallContact<float, 2>;
template class WallContact<float, 3>;

}  // namespace pliant::undeformed

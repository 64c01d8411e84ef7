#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "engine/lattice/point_algebra.hpp"
#include "engine/undeformed/held_directions.hpp"

/// Points that move with several particles, their carriers, and impulses on such points. Each
/// carrier takes its share of an impulse: momentum is conserved, and angular momentum if the
/// weighted mean of the carriers is the point.
///
/// Carriers are those of a body (BodyCarriers) or of a surface in contact (MovingSurface). Both
/// have `carrier(number)` and `change(number, velocity, displacement)`.
namespace pliant::undeformed {

/// A carrier and its share in the motion of a point; the shares of a point sum to 1.
struct Share {
  std::int32_t slot;
  double weight;
};

/// A particle that carries points.
template <int D>
struct Carrier {
  std::int32_t slot;
  double inverse_mass;  ///< [1/kg]
  /// Projection onto the directions that walls leave free; null without a wall.
  const std::array<double, D * D>* free_directions;
};

/// The particles of a body as carriers, numbered by their slots. Keeps references.
template <class T, int D>
class BodyCarriers {
 public:
  /// `displacement` is the array to which a step writes the displacements of the body, `rate` the
  /// force in a step over the change of momentum that it causes [1/s].
  BodyCarriers(Body<T, D>& body, std::array<Buffer<T>, D>& displacement,
               const HeldDirections<D>& held, double rate = 0)
      : body_(body), displacement_(displacement), held_(held), rate_(rate) {}

  Carrier<D> carrier(std::int32_t slot) const {
    const auto at = held_.find(slot);
    return {slot, double{body_.inverse_mass[slot]}, at == held_.end() ? nullptr : &at->second};
  }
  /// Adds to the velocity [m/s] and the displacement [m] of a particle.
  void change(std::int32_t slot, const Point<D>& velocity, const Point<D>& displacement) {
    for (int a = 0; a < D; ++a) {
      body_.velocity[a][slot] += static_cast<T>(velocity[a]);
      displacement_[a][slot] += static_cast<T>(displacement[a]);
      body_.add_contact_force(slot, a, rate_ * body_.mass[slot] * velocity[a]);
    }
  }

 private:
  Body<T, D>& body_;
  std::array<Buffer<T>, D>& displacement_;
  const HeldDirections<D>& held_;
  double rate_;
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

/// Change of a point's velocity per impulse on it, as if no wall held its carriers [1/kg].
template <class Carriers>
double free_compliance(const Carriers& carriers, std::span<const Share> shares) {
  double sum = 0;
  for (const Share& share : shares) {
    sum += share.weight * share.weight * carriers.carrier(share.slot).inverse_mass;
  }
  return sum;
}

/// Change of a point's velocity along the unit vector `n` per impulse along `n` [1/kg].
template <int D, class Carriers>
double compliance(const Carriers& carriers, std::span<const Share> shares, const Point<D>& n) {
  double sum = 0;
  for (const Share& share : shares) {
    const Carrier<D> carrier = carriers.carrier(share.slot);
    const auto* directions = carrier.free_directions;
    const double free = directions ? dot<D>(n, projected<D>(*directions, n)) : 1;
    sum += free * share.weight * share.weight * carrier.inverse_mass;
  }
  return sum;
}

/// Applies an impulse [N s] to a point, and displaces it by the response to another one, `moved`
/// [kg m].
template <int D, class Carriers>
void push_point(Carriers& carriers, std::span<const Share> shares, const Point<D>& impulse,
                const Point<D>& moved) {
  for (const Share& share : shares) {
    const Carrier<D> carrier = carriers.carrier(share.slot);
    const auto* directions = carrier.free_directions;
    const double response = share.weight * carrier.inverse_mass;
    Point<D> velocity = directions ? projected<D>(*directions, impulse) : impulse;
    Point<D> displacement = directions ? projected<D>(*directions, moved) : moved;
    for (int a = 0; a < D; ++a) velocity[a] *= response, displacement[a] *= response;
    carriers.change(share.slot, velocity, displacement);
  }
}

}  // namespace pliant::undeformed

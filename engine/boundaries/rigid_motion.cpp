#include "engine/boundaries/rigid_motion.hpp"

#include <cmath>

namespace pliant {

namespace {

template <int D>
Vector from(const Vector& centre, const Point<D>& x) {
  Vector r = padded<D>(x);
  for (int a = 0; a < 3; ++a) r[a] -= centre[a];
  return r;
}

template <int D>
Point<D> sum(Point<D> velocity, const Vector& by_spin) {
  for (int a = 0; a < D; ++a) velocity[a] += by_spin[a];
  return velocity;
}

}  // namespace

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Turn::Turn(const Vector& axis, double angle)
    : axis_(axis), sine_(std::sin(angle)), cosine_(std::cos(angle)) {}

// Rodrigues' formula.
Vector Turn::turned(const Vector& v, double sine) const {
  const Vector across = cross(axis_, v);
  const double along = axis_[0] * v[0] + axis_[1] * v[1] + axis_[2] * v[2];
  Vector result;
  for (int a = 0; a < 3; ++a) {
    result[a] = cosine_ * v[a] + sine * across[a] + (1 - cosine_) * along * axis_[a];
  }
  return result;
}

template <int D>
Point<D> RigidMotion<D>::at(const Point<D>& x) const {
  return turns() ? sum<D>(velocity, cross(spin, from<D>(centre, x))) : velocity;
}

template <int D>
Point<D> RigidMotion<D>::of(const Point<D>& x) const {
  return turns() ? sum<D>(velocity, cross(spin, turn(from<D>(start, x)))) : velocity;
}

template struct RigidMotion<2>;
template struct RigidMotion<3>;

}  // namespace pliant

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
Point<D> sum(Point<D> of_centre, const Vector& by_turning) {
  for (int a = 0; a < D; ++a) of_centre[a] += by_turning[a];
  return of_centre;
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
Point<D> RigidMotion<D>::of(const Point<D>& x) const {
  return turns ? sum<D>(velocity, cross(spin, turn(from<D>(start, x)))) : velocity;
}

template <int D>
Point<D> RigidMotion<D>::turned(const Point<D>& n) const {
  return turns ? unpadded<D>(turn(padded<D>(n))) : n;
}

template <int D>
Point<D> RigidStep<D>::shift_of(const Point<D>& x) const {
  if (!turns) return shift;
  const Vector r = from<D>(start, x), was = before(r), is = after(r);
  return sum<D>(shift, {is[0] - was[0], is[1] - was[1], is[2] - was[2]});
}

template <int D>
Point<D> RigidStep<D>::shift_at(const Point<D>& x) const {
  if (!turns) return shift;
  Vector is = from<D>(centre, x);
  for (int a = 0; a < D; ++a) is[a] -= shift[a];
  const Vector was = before(after.back(is));
  return sum<D>(shift, {is[0] - was[0], is[1] - was[1], is[2] - was[2]});
}

template struct RigidMotion<2>;
template struct RigidMotion<3>;
template struct RigidStep<2>;
template struct RigidStep<3>;

}  // namespace pliant

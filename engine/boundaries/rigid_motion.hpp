#pragma once

#include "engine/geometry/padded.hpp"

namespace pliant {

/// A rotation about an axis through the origin; the identity by default.
class Turn {
 public:
  Turn() = default;
  /// Rotation by an angle [rad] about a unit vector.
  Turn(const Vector& axis, double angle);
  Vector operator()(const Vector& v) const { return turned(v, sine_); }
  /// The inverse rotation.
  Vector back(const Vector& v) const { return turned(v, -sine_); }

 private:
  Vector turned(const Vector& v, double sine) const;

  Vector axis_ = {};
  double sine_ = 0, cosine_ = 1;
};

/// a x b
Vector cross(const Vector& a, const Vector& b);

/// The velocities of the points of a rigid solid at one time, by where they were at an earlier one.
template <int D>
struct RigidMotion {
  Point<D> velocity = {};  ///< of the solid's centre [m/s]
  bool turns = false;
  Vector spin = {};   ///< angular velocity [rad/s]; about z in 2D
  Vector start = {};  ///< place of the centre at the earlier time [m]
  Turn turn;          ///< rotation since then

  /// Velocity of the point that was at x at the earlier time [m/s].
  Point<D> of(const Point<D>& x) const;
  /// Present direction of the one that was `n` at the earlier time.
  Point<D> turned(const Point<D>& n) const;
  bool is_at_rest() const { return velocity == Point<D>{} && spin == Vector{}; }
};

/// The motion of a rigid solid in a step.
template <int D>
struct RigidStep {
  Point<D> shift = {};  ///< of the solid's centre [m]
  bool turns = false;
  Vector start = {};   ///< place of the centre at t = 0 [m]
  Vector centre = {};  ///< its place at the start of the step [m]
  Turn before, after;  ///< rotations since t = 0, at the start and the end of the step

  /// Displacement in the step of the point that was at x at t = 0 [m].
  Point<D> shift_of(const Point<D>& x) const;
  /// The same for the point that is at x when the step ends.
  Point<D> shift_at(const Point<D>& x) const;
};

}  // namespace pliant

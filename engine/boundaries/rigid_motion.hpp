#pragma once

#include "engine/geometry/padded.hpp"

namespace pliant {

/// A rotation about an axis through the origin; none by default.
class Turn {
 public:
  Turn() = default;
  /// By an angle [rad] about a unit vector.
  Turn(const Vector& axis, double angle);
  Vector operator()(const Vector& v) const { return turned(v, sine_); }
  /// The inverse of that.
  Vector back(const Vector& v) const { return turned(v, -sine_); }

 private:
  Vector turned(const Vector& v, double sine) const;

  Vector axis_ = {};
  double sine_ = 0, cosine_ = 1;
};

/// a x b
Vector cross(const Vector& a, const Vector& b);

/// The velocities of the points of a rigid solid at one time.
template <int D>
struct RigidMotion {
  Point<D> velocity = {};  ///< of its centre [m/s]
  bool turns = false;
  Vector spin = {};   ///< angular velocity [rad/s]; about z in 2D
  Vector start = {};  ///< where its centre was at t = 0 [m]
  Turn turn;          ///< since t = 0

  /// Velocity of the point that was at x at t = 0 [m/s].
  Point<D> of(const Point<D>& x) const;
};

/// What a rigid solid does in a step.
template <int D>
struct RigidStep {
  Point<D> shift = {};  ///< of its centre [m]
  bool turns = false;
  Vector start = {};   ///< where its centre was at t = 0 [m]
  Vector centre = {};  ///< where it is when the step begins [m]
  Turn before, after;  ///< since t = 0, when the step begins and ends

  /// Displacement in the step of the point that was at x at t = 0 [m].
  Point<D> shift_of(const Point<D>& x) const;
  /// Displacement in the step of the point that is at x when it ends [m].
  Point<D> shift_at(const Point<D>& x) const;
};

}  // namespace pliant

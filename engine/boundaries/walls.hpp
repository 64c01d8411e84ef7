#pragma once

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/boundaries/loads.hpp"
#include "engine/boundaries/rigid_motion.hpp"
#include "engine/case/case.hpp"
#include "engine/lattice/lattice.hpp"

namespace pliant {

/// How far a wall has moved and turned since t = 0.
template <int D>
struct WallPose {
  Point<D> offset = {};  ///< displacement of its centre [m]
  double angle = 0;      ///< [rad]
};

/// A rigid solid that moves and turns as prescribed. A body is attached to it, or slides along
/// it, or is only in contact with it as long as it presses.
template <int D>
class Wall {
 public:
  explicit Wall(const BoundaryCase& boundary);

  /// Distance to the solid [m], negative inside it.
  double distance(const Point<D>& x) const;
  /// Unit normal out of the solid, towards the tissue.
  Point<D> normal(const Point<D>& x) const;
  /// Area of the wall's surface over that of the parallel surface through x, which lies at `depth`
  /// behind it [m]; 1 of plane walls.
  double spread(const Point<D>& x, double depth) const;
  /// Coefficient of Coulomb friction; infinite for walls on which nothing slides.
  double friction() const { return friction_; }
  bool slips() const { return friction_ == 0; }
  bool is_attached() const { return is_attached_; }

  /// Velocity of its centre [m/s]: as prescribed, or as set since.
  Point<D> velocity(double t) const;
  /// The velocities of its points.
  RigidMotion<D> motion(double t) const;
  const std::optional<Point<D>>& set_velocity() const { return set_velocity_; }
  void set_velocity(const std::optional<Point<D>>& velocity) { set_velocity_ = velocity; }
  /// What it does in a step that begins at t, where it is: the displacement of its centre is that
  /// which is prescribed, or that of the velocity by Simpson's rule.
  RigidStep<D> step(double t, double time_step) const;
  /// Where it is; `move` makes a step.
  const WallPose<D>& pose() const { return pose_; }
  void move(double t, double time_step);
  void restore(const WallPose<D>& pose);

 private:
  Vector at_rest(const Point<D>& x) const;           // where the wall's material point was at t = 0
  Point<D> shift(double t, double time_step) const;  // of its centre in a step
  double spin(double t) const;                       // [rad/s]

  Shape shape_;
  VectorExpression velocity_;
  std::optional<VectorExpression> displacement_;
  std::optional<WallRotation> rotation_;
  double time_increment_;
  double friction_;
  bool is_attached_;
  std::optional<Point<D>> set_velocity_;
  WallPose<D> pose_;
  Turn turn_;  // by the angle of the pose
};

/// Pressure or traction on the free surface inside a region, (RP.45).
template <int D>
class SurfacePressure {
 public:
  explicit SurfacePressure(const BoundaryCase& boundary);
  bool acts_at(const Point<D>& x) const;
  /// As prescribed, or as set since [Pa].
  double value(double t) const { return set_value_ ? *set_value_ : pressure_(t); }
  const std::optional<double>& set_value() const { return set_value_; }
  void set_value(const std::optional<double>& value) { set_value_ = value; }

  /// A traction has no pressure.
  bool is_traction() const { return is_traction_; }
  BoundaryCase::LoadedArea area() const { return area_; }
  /// Whether the traction depends on the time alone.
  bool is_uniform() const { return is_uniform_; }
  /// [Pa]; one thread at a time may ask.
  Point<D> traction(const Point<D>& x, double t) const;

 private:
  Shape region_;
  Expression pressure_;
  VectorExpression traction_;
  BoundaryCase::LoadedArea area_;
  bool is_traction_, is_uniform_;
  std::optional<double> set_value_;
};

/// What bounds the bodies of a case, apart from their free surfaces.
template <int D>
struct Boundaries final : Loads {
  explicit Boundaries(const std::vector<BoundaryCase>& cases);

  void set_pressure(std::size_t boundary, double pressure) override;
  void set_wall_velocity(std::size_t boundary, const std::array<double, 3>& velocity) override;

  bool have_contact() const;
  bool have_attached_walls() const;
  bool have_attached_slip_walls() const;

  /// The attached wall nearest to `x` and the distance to it; {-1, infinity} without such walls.
  std::pair<int, double> nearest_wall(const Point<D>& x) const { return nearest(x, true); }
  /// The same of contact walls.
  std::pair<int, double> nearest_contact(const Point<D>& x) const { return nearest(x, false); }
  /// Distance to the nearest wall that material sticks to for good; infinity without such walls.
  double distance_to_no_slip(const Point<D>& x) const;

  std::vector<Wall<D>> walls;
  std::vector<SurfacePressure<D>> pressures;  ///< and tractions
  std::vector<int> wall_of;      ///< [boundary of the case] its place in `walls`, or -1
  std::vector<int> pressure_of;  ///< [boundary of the case] place of its pressure, or -1

 private:
  std::pair<int, double> nearest(const Point<D>& x, bool is_attached) const {
    std::pair<int, double> nearest{-1, std::numeric_limits<double>::infinity()};
    for (int w = 0; w < static_cast<int>(walls.size()); ++w) {
      if (walls[w].is_attached() != is_attached) continue;
      const double d = walls[w].distance(x);
      if (d < nearest.second) nearest = {w, d};
    }
    return nearest;
  }
};

extern template struct Boundaries<2>;
extern template struct Boundaries<3>;

}  // namespace pliant

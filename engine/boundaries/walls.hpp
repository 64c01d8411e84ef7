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

/// Displacement and rotation of a wall since t = 0.
template <int D>
struct WallPose {
  Point<D> offset = {};  ///< displacement of its centre [m]
  double angle = 0;      ///< [rad]
};

/// A rigid solid with a prescribed motion. A body is attached to it, slides along it, or is in
/// contact with it while it presses.
template <int D>
class Wall {
 public:
  explicit Wall(const BoundaryCase& boundary);

  /// Distance to the solid [m], negative inside it.
  double distance(const Point<D>& x) const;
  /// Outward unit normal of the solid, towards the tissue.
  Point<D> normal(const Point<D>& x) const;
  /// Place at t = 0 of the wall's material point that is now at x.
  Vector at_rest(const Point<D>& x) const;
  /// Ratio of the area of the wall's surface to that of the parallel surface through x, which is at
  /// `depth` behind it [m]; 1 for plane walls.
  double spread(const Point<D>& x, double depth) const;
  /// Coefficient of Coulomb friction; infinite for no-slip walls.
  double friction() const { return friction_; }
  bool slips() const { return friction_ == 0; }
  bool is_attached() const { return is_attached_; }

  /// Velocity of its centre [m/s]: the one that was set, or else the prescribed one.
  Point<D> velocity(double t) const;
  /// The velocities of its points, by where they were when the wall had the pose `since`: at t = 0
  /// by default.
  RigidMotion<D> motion(double t, const WallPose<D>& since = {}) const;
  const std::optional<Point<D>>& set_velocity() const { return set_velocity_; }
  void set_velocity(const std::optional<Point<D>>& velocity) { set_velocity_ = velocity; }
  /// Its motion in a step from time t on. The displacement of its centre is the prescribed one, or
  /// the integral of the velocity by Simpson's rule.
  RigidStep<D> step(double t, double time_step) const;
  bool turns() const { return rotation_.has_value(); }
  /// Present place of the centre of a wall that turns [m].
  Vector centre() const;
  /// Its present pose; `move` advances it by a step.
  const WallPose<D>& pose() const { return pose_; }
  void move(double t, double time_step);
  void restore(const WallPose<D>& pose);

 private:
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
  Turn turn_;  // rotation by the angle of the pose
};

/// Pressure or traction on the free surface inside a region, (RP.45).
template <int D>
class SurfacePressure {
 public:
  explicit SurfacePressure(const BoundaryCase& boundary);
  bool acts_at(const Point<D>& x) const;
  /// The pressure that was set, or else the prescribed one [Pa]; 0 for a traction.
  double pressure(const Point<D>& x, double t) const;
  const std::optional<double>& set_value() const { return set_value_; }
  void set_value(const std::optional<double>& value) { set_value_ = value; }

  bool is_traction() const { return is_traction_; }
  BoundaryCase::LoadedArea area() const { return area_; }
  /// Whether the prescribed load differs from place to place.
  bool depends_on_place() const { return !is_uniform_; }
  /// Whether it depends only on time.
  bool is_uniform() const { return is_uniform_ || set_value_; }
  /// [Pa]; 0 for a pressure
  Point<D> traction(const Point<D>& x, double t) const;

 private:
  Shape region_;
  Expression pressure_;
  VectorExpression traction_;
  BoundaryCase::LoadedArea area_;
  bool is_traction_, is_uniform_;
  std::optional<double> set_value_;
};

/// The boundaries of a case, except for free surfaces.
template <int D>
struct Boundaries final : Loads {
  explicit Boundaries(const std::vector<BoundaryCase>& cases);

  void set_pressure(std::size_t boundary, double pressure) override;
  void set_wall_velocity(std::size_t boundary, const std::array<double, 3>& velocity) override;

  bool have_contact() const;
  bool have_tractions() const;
  bool have_loads_by_place() const;  ///< loads that depend on the place
  /// Whether a load, or -1 for none, is a traction.
  bool is_traction(int load) const { return load >= 0 && pressures[load].is_traction(); }
  /// Whether a load is a pressure that depends only on time.
  bool is_uniform_pressure(int load) const {
    return !pressures[load].is_traction() && pressures[load].is_uniform();
  }
  bool have_attached_walls() const;
  bool have_attached_slip_walls() const;

  /// The attached wall nearest to `x` and the distance to it; {-1, infinity} without such walls.
  std::pair<int, double> nearest_wall(const Point<D>& x) const { return nearest(x, true); }
  /// The same for contact walls.
  std::pair<int, double> nearest_contact(const Point<D>& x) const { return nearest(x, false); }
  /// Distance to the nearest attached no-slip wall; infinity without such walls.
  double distance_to_no_slip(const Point<D>& x) const;

  std::vector<Wall<D>> walls;
  std::vector<SurfacePressure<D>> pressures;  ///< and tractions
  std::vector<int> wall_of;                   ///< [boundary of the case] index in `walls`, or -1
  std::vector<int> pressure_of;  ///< [boundary of the case] index in `pressures`, or -1

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

#include "engine/boundaries/walls.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <limits>
#include <stdexcept>

#include "engine/case/vocabulary/boundary_kinds.hpp"
#include "engine/case/vocabulary/contact_laws.hpp"
#include "engine/geometry/padded.hpp"
#include "engine/geometry/signed_distance.hpp"

namespace pliant {

namespace {

double friction_of(const BoundaryCase& boundary) {
  const bool slides = boundary.kind == BoundaryCase::Kind::contact_wall
                          ? row_of(boundary.friction).slides
                          : boundary.kind == BoundaryCase::Kind::slip_wall;
  if (slides) return 0;
  return boundary.friction_coefficient.value_or(std::numeric_limits<double>::infinity());
}

}  // namespace

template <int D>
Wall<D>::Wall(const BoundaryCase& boundary)
    : shape_(boundary.geometry),
      velocity_(boundary.velocity),
      displacement_(boundary.displacement),
      rotation_(boundary.rotation),
      time_increment_(boundary.time_increment),
      friction_(friction_of(boundary)),
      is_attached_(row_of(boundary.kind).is_attached) {}

template <int D>
Vector Wall<D>::at_rest(const Point<D>& x) const {
  Vector at = {};
  for (int a = 0; a < D; ++a) at[a] = x[a] - pose_.offset[a];
  if (!rotation_) return at;
  const Vector& centre = rotation_->centre;
  for (int a = 0; a < 3; ++a) at[a] -= centre[a];
  at = turn_.back(at);
  for (int a = 0; a < 3; ++a) at[a] += centre[a];
  return at;
}

template <int D>
double Wall<D>::distance(const Point<D>& x) const {
  return signed_distance(shape_, at_rest(x), D);
}

template <int D>
Point<D> Wall<D>::normal(const Point<D>& x) const {
  const Vector out = turn_(outward_direction(shape_, at_rest(x), D));
  Point<D> n;
  for (int a = 0; a < D; ++a) n[a] = out[a];
  return n;
}

// det(I + depth grad n): the normals of a ball diverge, so its surface is larger than the parallel
// one inside. Where normals jump, behind edges, such a slot represents no part of the surface.
template <int D>
double Wall<D>::spread(const Point<D>& x, double depth) const {
  if (shape_.kind == Shape::Kind::half_space || depth == 0) return 1;
  constexpr double widest = 3, step = 0.25;  // relative to the depth
  Eigen::Matrix<double, D, D> stretch = Eigen::Matrix<double, D, D>::Identity();
  for (int j = 0; j < D; ++j) {
    Point<D> before = x, after = x;
    before[j] -= step * depth;
    after[j] += step * depth;
    const Point<D> n0 = normal(before), n1 = normal(after);
    for (int i = 0; i < D; ++i) stretch(i, j) += (n1[i] - n0[i]) / (2 * step);
  }
  return std::clamp(stretch.determinant(), 0., widest);
}

template <int D>
RigidMotion<D> Wall<D>::motion(double t, const WallPose<D>& since) const {
  RigidMotion<D> motion;
  motion.velocity = velocity(t);
  if (!rotation_) return motion;
  motion.turns = true;
  motion.start = rotation_->centre;
  for (int a = 0; a < D; ++a) motion.start[a] += since.offset[a];
  motion.turn = Turn(rotation_->axis, rotation_->angle(t) - since.angle);
  const double rate = spin(t);
  for (int a = 0; a < 3; ++a) motion.spin[a] = rate * rotation_->axis[a];
  return motion;
}

template <int D>
double Wall<D>::spin(double t) const {
  const double before = std::max(t - time_increment_, 0.0), after = t + time_increment_;
  return (rotation_->angle(after) - rotation_->angle(before)) / (after - before);
}

template <int D>
Point<D> Wall<D>::velocity(double t) const {
  if (set_velocity_) return *set_velocity_;
  Point<D> u;
  if (displacement_) {
    const double before = std::max(t - time_increment_, 0.0), after = t + time_increment_;
    for (int a = 0; a < D; ++a) {
      u[a] = ((*displacement_)[a](after) - (*displacement_)[a](before)) / (after - before);
    }
    return u;
  }
  for (int a = 0; a < D; ++a) u[a] = velocity_[a](t);
  return u;
}

template <int D>
Point<D> Wall<D>::shift(double t, double time_step) const {
  Point<D> moved;
  if (displacement_ && !set_velocity_) {
    for (int a = 0; a < D; ++a) {
      moved[a] = (*displacement_)[a](t + time_step) - (*displacement_)[a](t);
    }
    return moved;
  }
  const Point<D> u0 = velocity(t), u1 = velocity(t + time_step / 2), u2 = velocity(t + time_step);
  for (int a = 0; a < D; ++a) moved[a] = time_step / 6 * (u0[a] + 4 * u1[a] + u2[a]);
  return moved;
}

template <int D>
RigidStep<D> Wall<D>::step(double t, double time_step) const {
  RigidStep<D> step;
  step.shift = shift(t, time_step);
  if (!rotation_) return step;
  step.turns = true;
  step.start = rotation_->centre;
  step.centre = centre();
  step.before = Turn(rotation_->axis, rotation_->angle(t));
  step.after = Turn(rotation_->axis, rotation_->angle(t + time_step));
  return step;
}

template <int D>
Vector Wall<D>::centre() const {
  Vector centre = rotation_->centre;
  for (int a = 0; a < D; ++a) centre[a] += pose_.offset[a];
  return centre;
}

template <int D>
void Wall<D>::move(double t, double time_step) {
  const Point<D> moved = shift(t, time_step);
  WallPose<D> pose = pose_;
  for (int a = 0; a < D; ++a) pose.offset[a] += moved[a];
  if (rotation_) pose.angle = rotation_->angle(t + time_step);
  restore(pose);
}

template <int D>
void Wall<D>::restore(const WallPose<D>& pose) {
  pose_ = pose;
  if (rotation_) turn_ = Turn(rotation_->axis, pose_.angle);
}

template <int D>
SurfacePressure<D>::SurfacePressure(const BoundaryCase& boundary)
    : region_(boundary.geometry),
      pressure_(boundary.pressure),
      traction_(boundary.traction),
      area_(boundary.area),
      is_traction_(boundary.kind == BoundaryCase::Kind::traction),
      is_uniform_(!pressure_.uses_place() &&
                  std::ranges::none_of(traction_, &Expression::uses_place)) {}

template <int D>
double SurfacePressure<D>::pressure(const Point<D>& x, double t) const {
  if (set_value_) return *set_value_;
  const Vector at = padded<D>(x);
  return pressure_(at[0], at[1], at[2], t);
}

template <int D>
Point<D> SurfacePressure<D>::traction(const Point<D>& x, double t) const {
  const Vector at = padded<D>(x);
  Point<D> value;
  for (int a = 0; a < D; ++a) value[a] = traction_[a](at[0], at[1], at[2], t);
  return value;
}

// Points on a face are in its plane only up to rounding: a region that begins there contains them
// all.
template <int D>
bool SurfacePressure<D>::acts_at(const Point<D>& x) const {
  constexpr double rounding = 1e-6;  // as of files of meshes
  const Vector at = padded<D>(x);
  return signed_distance(region_, at, D) <= rounding * std::hypot(at[0], at[1], at[2]);
}

template <int D>
Boundaries<D>::Boundaries(const std::vector<BoundaryCase>& cases) {
  for (const BoundaryCase& boundary : cases) {
    const bool is_wall = row_of(boundary.kind).is_wall;
    wall_of.push_back(is_wall ? static_cast<int>(walls.size()) : -1);
    const bool is_pressure = boundary.kind == BoundaryCase::Kind::pressure;
    pressure_of.push_back(is_pressure ? static_cast<int>(pressures.size()) : -1);
    if (!is_wall) {
      pressures.emplace_back(boundary);
    } else {
      walls.emplace_back(boundary);
    }
  }
}

template <int D>
void Boundaries<D>::set_pressure(std::size_t boundary, double pressure) {
  const int place = pressure_of.at(boundary);
  if (place < 0) throw std::invalid_argument("only boundaries of kind pressure have one to set");
  pressures[place].set_value(pressure);
}

template <int D>
void Boundaries<D>::set_wall_velocity(std::size_t boundary, const std::array<double, 3>& velocity) {
  const int place = wall_of.at(boundary);
  if (place < 0) throw std::invalid_argument("a load has no velocity to set");
  Point<D> u;
  for (int a = 0; a < D; ++a) u[a] = velocity[a];
  walls[place].set_velocity(u);
}

template <int D>
bool Boundaries<D>::have_contact() const {
  return std::any_of(walls.begin(), walls.end(),
                     [](const Wall<D>& wall) { return !wall.is_attached(); });
}

template <int D>
bool Boundaries<D>::have_tractions() const {
  return std::any_of(pressures.begin(), pressures.end(),
                     [](const SurfacePressure<D>& load) { return load.is_traction(); });
}

template <int D>
bool Boundaries<D>::have_loads_by_place() const {
  return std::ranges::any_of(pressures, &SurfacePressure<D>::depends_on_place);
}

template <int D>
bool Boundaries<D>::have_attached_walls() const {
  return std::ranges::any_of(walls, [](const Wall<D>& wall) { return wall.is_attached(); });
}

template <int D>
bool Boundaries<D>::have_attached_slip_walls() const {
  return std::any_of(walls.begin(), walls.end(),
                     [](const Wall<D>& wall) { return wall.is_attached() && wall.slips(); });
}

template <int D>
double Boundaries<D>::distance_to_no_slip(const Point<D>& x) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Wall<D>& wall : walls) {
    if (wall.is_attached() && !wall.slips()) least = std::min(least, wall.distance(x));
  }
  return least;
}

template class Wall<2>;
template class Wall<3>;
template class SurfacePressure<2>;
template class SurfacePressure<3>;
template struct Boundaries<2>;
template struct Boundaries<3>;

}  // namespace pliant

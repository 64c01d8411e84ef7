#include "engine/remeshed/ghosts/rigid_velocity.hpp"

#include <Eigen/Geometry>

#include "engine/method/decompositions.hpp"

namespace pliant::remeshed {

template <class T, int D>
std::array<T, D> rigid_velocity(const Body<T, D>& body, int stage, const BlockGhosts<T, D>& ghosts,
                                std::size_t g) {
  using Vector3 = Eigen::Vector3d;
  const FieldStore<T, D>& state = body.stage[buffer_of(stage)];
  const FieldStore<T, D>& place = body.stage[drift_buffer_of(stage)];
  const std::int64_t begin = ghosts.begin[g], end = ghosts.begin[g + 1];
  const Layout<D>& layout = body.population.layout;
  const auto particle = [&](std::int64_t k) {
    return body.population.slot_of_record[kernels::record_of(ghosts.pairs[k])];
  };
  const auto position = [&](std::int64_t slot) {
    const Point<D> node = body.lattice.node(layout.cell(slot));
    Vector3 x = Vector3::Zero();
    for (int a = 0; a < D; ++a) x[a] = node[a] + place.get(Field::drift, a)[slot];
    return x;
  };
  const auto velocity = [&](std::int64_t slot) {
    Vector3 u = Vector3::Zero();
    for (int a = 0; a < D; ++a) u[a] = state.get(Field::velocity, a)[slot];
    return u;
  };
  Vector3 centre = Vector3::Zero(), mean = Vector3::Zero();
  for (std::int64_t k = begin; k < end; ++k) {
    centre += position(particle(k)) / (end - begin);
    mean += velocity(particle(k)) / (end - begin);
  }
  Vector3 moment = Vector3::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  for (std::int64_t k = begin; k < end; ++k) {
    const Vector3 r = position(particle(k)) - centre;
    moment += r.cross(velocity(particle(k)) - mean);
    inertia += r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose();
  }
  // If the neighbours lie on a line, the rotation about it is undetermined and set to 0.
  const Vector3 omega = pseudo_inverse<3>(inertia) * moment;
  const Vector3 u = mean + omega.cross(position(ghosts.slot[g]) - centre);
  std::array<T, D> result;
  for (int a = 0; a < D; ++a) result[a] = static_cast<T>(u[a]);
  return result;
}

template std::array<double, 2> rigid_velocity<double, 2>(const Body<double, 2>&, int,
                                                         const BlockGhosts<double, 2>&,
                                                         std::size_t);
template std::array<double, 3> rigid_velocity<double, 3>(const Body<double, 3>&, int,
                                                         const BlockGhosts<double, 3>&,
                                                         std::size_t);
template std::array<float, 2> rigid_velocity<float, 2>(const Body<float, 2>&, int,
                                                       const BlockGhosts<float, 2>&, std::size_t);
template std::array<float, 3> rigid_velocity<float, 3>(const Body<float, 3>&, int,
                                                       const BlockGhosts<float, 3>&, std::size_t);

}  // namespace pliant::remeshed

#include "engine/remeshed/remeshing/rigid_motion.hpp"

#include <Eigen/Cholesky>

#include "engine/boundaries/rigid_motion.hpp"

namespace pliant::remeshed {

void add(MotionIntegrals& sum, const MotionIntegrals& other) {
  sum.mass += other.mass;
  sum.kinetic_energy += other.kinetic_energy;
  for (int a = 0; a < 3; ++a) {
    sum.first_moment[a] += other.first_moment[a];
    sum.momentum[a] += other.momentum[a];
    sum.angular_momentum[a] += other.angular_momentum[a];
    for (int b = 0; b < 3; ++b) sum.second_moment[a][b] += other.second_moment[a][b];
  }
}

Vector mass_centre(const MotionIntegrals& motion) {
  Vector centre;
  for (int a = 0; a < 3; ++a) centre[a] = motion.first_moment[a] / motion.mass;
  return centre;
}

Vector spin_of(const MotionIntegrals& motion) {
  const Vector of_centre = cross(mass_centre(motion), motion.momentum);
  Vector spin;
  for (int a = 0; a < 3; ++a) spin[a] = motion.angular_momentum[a] - of_centre[a];
  return spin;
}

template <int D>
Vector angular_velocity(const MotionIntegrals& motion, const Vector& spin) {
  Eigen::Matrix3d second;
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      second(a, b) = motion.second_moment[a][b] -
                     motion.first_moment[a] * motion.first_moment[b] / motion.mass;
    }
  }
  if constexpr (D == 2) return {0, 0, spin[2] / second.trace()};
  const Eigen::Matrix3d inertia = second.trace() * Eigen::Matrix3d::Identity() - second;
  const Eigen::Vector3d omega = inertia.llt().solve(Eigen::Vector3d(spin[0], spin[1], spin[2]));
  return {omega[0], omega[1], omega[2]};
}

template Vector angular_velocity<2>(const MotionIntegrals&, const Vector&);
template Vector angular_velocity<3>(const MotionIntegrals&, const Vector&);

}  // namespace pliant::remeshed

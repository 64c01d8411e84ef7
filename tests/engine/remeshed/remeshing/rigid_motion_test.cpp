#include "engine/remeshed/remeshing/rigid_motion.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <vector>

// The rigid motion computed from integrals of a body, tested with a few point masses.
namespace pliant::remeshed {
namespace {

struct PointMass {
  double mass;
  Eigen::Vector3d position;
};

/// Integrals over point masses that move with a + omega x r, with r from the origin.
MotionIntegrals integrals_of(const std::vector<PointMass>& points, const Eigen::Vector3d& a,
                             const Eigen::Vector3d& omega) {
  MotionIntegrals sum;
  for (const auto& [mass, r] : points) {
    const Eigen::Vector3d momentum = mass * (a + omega.cross(r)), about_origin = r.cross(momentum);
    sum.mass += mass;
    for (int i = 0; i < 3; ++i) {
      sum.first_moment[i] += mass * r[i];
      sum.momentum[i] += momentum[i];
      sum.angular_momentum[i] += about_origin[i];
      for (int j = 0; j < 3; ++j) sum.second_moment[i][j] += mass * r[i] * r[j];
    }
  }
  return sum;
}

const std::vector<PointMass> five_points = {{1, {0.3, -0.2, 0.5}},
                                            {2, {1.1, 0.4, -0.3}},
                                            {0.5, {-0.7, 0.9, 0.2}},
                                            {1.5, {0.2, 0.8, 1.4}},
                                            {3, {-0.4, -1.2, 0.1}}};

TEST(rigid_motion, the_angular_velocity_of_a_rigid_body_follows_from_its_spin) {
  const Eigen::Vector3d omega(0.4, -1.3, 0.7);
  const MotionIntegrals motion = integrals_of(five_points, {5, -3, 2}, omega);
  const Vector found = angular_velocity<3>(motion, spin_of(motion));
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], omega[i], 1e-13);
}

TEST(rigid_motion, in_2d_a_body_turns_about_z) {
  std::vector<PointMass> in_plane = five_points;
  for (PointMass& point : in_plane) point.position[2] = 0;
  const MotionIntegrals motion = integrals_of(in_plane, {5, -3, 0}, {0, 0, 0.7});
  const Vector found = angular_velocity<2>(motion, spin_of(motion));
  EXPECT_EQ(found[0], 0);
  EXPECT_EQ(found[1], 0);
  EXPECT_NEAR(found[2], 0.7, 1e-14);
}

TEST(rigid_motion, a_translation_has_no_spin) {
  const MotionIntegrals motion = integrals_of(five_points, {5, -3, 2}, {0, 0, 0});
  for (const double component : spin_of(motion)) EXPECT_NEAR(component, 0, 1e-14 * 50);
}

TEST(rigid_motion, integrals_of_two_parts_add_up_to_those_of_the_body) {
  const Eigen::Vector3d a(5, -3, 2), omega(0.4, -1.3, 0.7);
  const auto middle = five_points.begin() + 2;
  MotionIntegrals sum = integrals_of({five_points.begin(), middle}, a, omega);
  add(sum, integrals_of({middle, five_points.end()}, a, omega));
  const MotionIntegrals whole = integrals_of(five_points, a, omega);
  EXPECT_NEAR(sum.mass, whole.mass, 1e-14);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(mass_centre(sum)[i], mass_centre(whole)[i], 1e-14);
    EXPECT_NEAR(spin_of(sum)[i], spin_of(whole)[i], 1e-13);
  }
}

}  // namespace
}  // namespace pliant::remeshed

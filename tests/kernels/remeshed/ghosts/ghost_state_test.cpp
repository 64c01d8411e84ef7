#include "kernels/remeshed/ghosts/ghost_state.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "kernels/remeshed/ghosts/wall_friction.hpp"

namespace pliant::kernels {
namespace {

using Place = RecordPlace<2>;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A wall that does not turn.
WallSite<double, 2> site(const VectorOf<double, 2>& velocity, const VectorOf<double, 2>& normal,
                         double friction) {
  return {velocity, velocity, normal, friction};
}

/// Sums of random records with a unit normal among them.
template <int D>
struct RandomSum {
  RandomSum() {
    static std::mt19937 random(11);
    std::uniform_real_distribution<double> value(-1, 1);
    for (double& v : values) v = value(random);
    normal = unit_normal<double, D>(sum());
    for (double& t : tangent) t = value(random);
    double along = 0;
    for (int i = 0; i < D; ++i) along += tangent[i] * normal[i];
    for (int i = 0; i < D; ++i) tangent[i] -= along * normal[i];
  }
  RecordSum<double, D> sum() const { return {values.data()}; }

  std::array<double, record_width<D>> values;
  VectorOf<double, D> normal, tangent;
};

template <int D>
double component(const SymmetricOf<double, D>& s, const VectorOf<double, D>& a,
                 const VectorOf<double, D>& b) {
  double value = 0;
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) value += a[i] * s[symmetric_index<D>(i, j)] * b[j];
  }
  return value;
}

template <int D>
void expect_prescribed_traction() {
  for (int trial = 0; trial < 20; ++trial) {
    const RandomSum<D> random;
    const auto& n = random.normal;
    const auto& t = random.tangent;
    const SymmetricOf<double, D> stress =
        with_traction<double, D>(random.sum(), n, 0.7, random.tangent);
    SymmetricOf<double, D> before;
    for (int i = 0; i < D; ++i) {
      for (int j = i; j < D; ++j) before[symmetric_index<D>(i, j)] = random.sum().stress(i, j);
    }
    double t2 = 0;
    for (int i = 0; i < D; ++i) t2 += t[i] * t[i];
    EXPECT_NEAR((component<D>(stress, n, n)), 0.7, 1e-14);
    EXPECT_NEAR((component<D>(stress, n, t)), t2, 1e-14);
    EXPECT_NEAR((component<D>(stress, t, t)), (component<D>(before, t, t)), 1e-14);
  }
}

TEST(ghost_state, takes_its_traction_from_one_fit_and_the_rest_from_the_other) {
  expect_prescribed_traction<2>();
  expect_prescribed_traction<3>();
}

TEST(ghost_state, traction_and_shear_are_the_parts_of_the_stress_on_a_plane) {
  const RandomSum<3> random;
  VectorOf<double, 3> s_n;
  const double s_nn = traction<double, 3>(random.sum(), random.normal, s_n);
  const VectorOf<double, 3> tau = shear<double, 3>(random.sum(), random.normal);
  double across = 0;
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(tau[i] + s_nn * random.normal[i], s_n[i], 1e-15);
    across += tau[i] * random.normal[i];
  }
  EXPECT_NEAR(across, 0, 1e-15);
}

TEST(ghost_state, a_body_at_rest_under_its_surface_pressure_stays_at_rest) {
  // All fits of a uniform state give this state; the constrained one that of f - f_surface.
  const double pressure = 0.3;
  std::array<double, record_width<2>> uniform = {};
  uniform[Place::stress] = uniform[Place::stress + 2] = -pressure;
  uniform[Place::slope] = 1;
  std::array<double, record_width<2>> constrained = uniform;
  const double weight = 0.4;  // sum of b
  for (double& v : constrained) v *= weight;
  const GhostFits<double, 2> everywhere{
      {uniform.data()}, {constrained.data()}, {uniform.data()}, weight, 1};
  const std::array<double, record_width<2>> none = {};
  const GhostFits<double, 2> beside_a_wall{
      {uniform.data()}, {constrained.data()}, {none.data()}, weight, 0};
  Material<double> material;
  material.bulk_modulus = 80;
  material.shear_modulus = 30;
  const Impedance<double> impedance(material);
  for (const auto& ghost :
       {free_surface_ghost<double, 2>(everywhere, pressure, impedance),
        free_surface_ghost<double, 2>(beside_a_wall, pressure, impedance),
        wall_ghost<double, 2>(everywhere, site({0, 0}, {-1, 0}, infinity), impedance)}) {
    for (const double u : ghost.velocity) EXPECT_NEAR(u, 0, 1e-16);
    EXPECT_NEAR(ghost.stress[0], -pressure, 1e-15);
    EXPECT_NEAR(ghost.stress[1], 0, 1e-15);
    EXPECT_NEAR(ghost.stress[2], -pressure, 1e-15);
  }
}

/// Fits of a state of uniform stress s_yy and s_xy and uniform velocity u_y.
struct UniformFits {
  UniformFits(double s_yy, double s_xy, double u_y) {
    record[Place::velocity + 1] = u_y;
    record[Place::stress + 1] = s_xy;
    record[Place::stress + 2] = s_yy;
  }
  GhostFits<double, 2> fits() const {
    return {{record.data()}, {record.data()}, {record.data()}, 1, 1};
  }
  std::array<double, record_width<2>> record = {};
};

// The half space between body and wall: its velocity is compared with its stress.
TEST(ghost_state, the_pressure_of_a_wall_is_that_of_the_wave_it_sends_back) {
  Material<double> material;
  material.bulk_modulus = 80;
  material.shear_modulus = 30;
  const Impedance<double> impedance(material);
  const auto pressure = [&](double s_yy, double u_y, double wall) {
    const UniformFits state(s_yy, 0, u_y);
    const auto of = [&](bool slips) {
      return wall_pressure<double, 2>(state.fits(), site({0, wall}, {0, 1}, 0.), slips, impedance);
    };
    EXPECT_DOUBLE_EQ(of(true), of(false));
    return of(true);
  };
  const double wave = 0.5 * impedance.pressure_wave;
  EXPECT_DOUBLE_EQ(pressure(-3, 0, 0), 3);
  EXPECT_DOUBLE_EQ(pressure(-3, -0.5, 0), 3 + wave);
  EXPECT_DOUBLE_EQ(pressure(-3, 0.5, 0), 3 - wave) << "it moves away: the wall would pull";
  EXPECT_DOUBLE_EQ(pressure(1, 0.5, 1), wave - 1) << "the wall comes nearer";
}

TEST(ghost_state, a_wall_pushes_against_the_traction_and_only_a_no_slip_one_along_itself) {
  Material<double> material;
  material.bulk_modulus = 80;
  material.shear_modulus = 30;
  const Impedance<double> impedance(material);
  const VectorOf<double, 2> floor = {0, 1};
  const UniformFits at_rest(-3, 0.5, 0);
  const auto sliding =
      wall_force_density<double, 2>(at_rest.fits(), site({0, 0}, floor, 0.), impedance);
  EXPECT_DOUBLE_EQ(sliding[0], 0);
  EXPECT_DOUBLE_EQ(sliding[1], 3);
  const auto no_slip =
      wall_force_density<double, 2>(at_rest.fits(), site({0, 0}, floor, infinity), impedance);
  EXPECT_DOUBLE_EQ(no_slip[0], -0.5);
  EXPECT_DOUBLE_EQ(no_slip[1], 3);
  // Stress-free material hits a wall at speed w: rho c w in the ghost, nothing before it.
  const auto hit = wall_force_density<double, 2>(UniformFits(0, 0, -2).fits(),
                                                 site({0, 0}, floor, 0.), impedance);
  EXPECT_DOUBLE_EQ(hit[1], impedance.pressure_wave);
}

// Uniform stress: both kinds of ghosts give the same pressure.
TEST(ghost_state, friction_holds_up_to_its_coefficient_times_the_pressure) {
  Material<double> material;
  material.bulk_modulus = 80;
  material.shear_modulus = 30;
  const Impedance<double> impedance(material);
  const UniformFits pressed(-3, 0.5, 0);
  for (const double friction : {0.1, 0.16, 0.17, 0.5}) {
    const auto push =
        wall_force_density<double, 2>(pressed.fits(), site({0, 0}, {0, 1}, friction), impedance);
    EXPECT_DOUBLE_EQ(push[0], -std::min(0.5, 3 * friction));
    EXPECT_DOUBLE_EQ(push[1], 3);
    const auto ghost =
        friction_wall_ghost<double, 2>(pressed.fits(), site({0, 0}, {0, 1}, friction), impedance);
    EXPECT_EQ(ghost.velocity[0] == 0, 3 * friction > 0.5) << "it slides otherwise";
  }
}

// Sums at the foot point; the linear and constrained fits are evaluated one spacing behind it.
TEST(ghost_state, behind_a_slip_wall_is_what_lies_at_it_but_what_changes_its_sign) {
  Material<double> material;
  material.bulk_modulus = 80;
  material.shear_modulus = 30;
  const Impedance<double> impedance(material);
  //                                                s_xx  s_xy  s_yy   p  u_x   u_y
  const std::array<double, record_width<2>> foot = {-1.0, 0.0, -4.0, 0, 0.3, 0.00},
                                            linear = {-1.5, 0.6, -4.5, 0, 0.5, -0.2},
                                            constrained = {-1.7, 0.4, -4.7, 0, 0.7, -0.1};
  const GhostFits<double, 2> fits{{linear.data()}, {constrained.data()}, {foot.data()}, 0, 1};
  const auto ghost = slip_wall_ghost<double, 2>(fits, site({7, 0}, {0, 1}, 0.), impedance);
  EXPECT_DOUBLE_EQ(ghost.velocity[0], 0.3);
  EXPECT_DOUBLE_EQ(ghost.velocity[1], -0.1);
  EXPECT_DOUBLE_EQ(ghost.stress[0], -1);
  EXPECT_DOUBLE_EQ(ghost.stress[1], 0.4);
  EXPECT_DOUBLE_EQ(ghost.stress[2], -4);
  EXPECT_DOUBLE_EQ((wall_pressure<double, 2>(fits, site({7, 0}, {0, 1}, 0.), true, impedance)),
                   3.75)
      << "the mean of 4 in the ghost and 3.5 in the body";
  EXPECT_DOUBLE_EQ((wall_pressure<double, 2>(fits, site({7, 0}, {0, 1}, 0.), false, impedance)), 4);
}

// A body turns with its wall: there is no jump at the foot, and the ghost turns as well.
TEST(ghost_state, behind_a_wall_that_turns_has_the_velocity_of_its_solid) {
  Material<double> material;
  material.density = 1;
  material.bulk_modulus = 80;
  material.shear_modulus = 30;
  const Impedance<double> impedance(material);
  const std::array<double, record_width<2>> foot = {-1.0, 0.2, -4.0, 0, 0.3, -0.2},
                                            constrained = {0, 0, 0, 0, -0.5, 0.1};
  const GhostFits<double, 2> fits{{foot.data()}, {constrained.data()}, {foot.data()}, -1, 1};
  const WallSite<double, 2> wall{{0.3, -0.2}, {0.4, -0.15}, {0, 1}, infinity};
  const auto ghost = wall_ghost<double, 2>(fits, wall, impedance);
  EXPECT_DOUBLE_EQ(ghost.velocity[0], 0.3);
  EXPECT_DOUBLE_EQ(ghost.velocity[1], -0.2);
  for (int c = 0; c < 3; ++c) EXPECT_DOUBLE_EQ(ghost.stress[c], foot[c]);
}

// sigma_yy is -4 on the wall and decreases by 0.5 per spacing behind it, as under a weight.
TEST(ghost_state, a_slip_wall_carries_the_weight_between_its_ghosts_and_itself) {
  Material<double> material;
  material.bulk_modulus = 80;
  material.shear_modulus = 30;
  const Impedance<double> impedance(material);
  const UniformFits foot(-4, 0, 0), linear(-4.5, 0, 0);
  const GhostFits<double, 2> fits{
      {linear.record.data()}, {foot.record.data()}, {foot.record.data()}, 0, 1};
  WallSite<double, 2> wall = site({0, 0}, {0, 1}, 0);
  wall.rise = -0.5;
  EXPECT_DOUBLE_EQ((slip_wall_ghost<double, 2>(fits, wall, impedance).stress[2]), -4.5);
  EXPECT_DOUBLE_EQ((wall_pressure<double, 2>(fits, wall, true, impedance)), 4);
}

}  // namespace
}  // namespace pliant::kernels

#include "kernels/remeshed/ghosts/interface_traction.hpp"

#include <gtest/gtest.h>

#include <random>

namespace pliant::kernels {
namespace {

/// A side of an interface, with the outward normal along grad phi.
template <int D>
struct Side {
  std::array<double, record_width<D>> record = {};
  Impedance<double> impedance;

  Side(const VectorOf<double, D>& n, double young, double density)
      : impedance(Material<double>{
            .density = density, .bulk_modulus = young / 1.2, .shear_modulus = young / 2.6}) {
    static std::mt19937 random(5);
    std::uniform_real_distribution<double> value(-1, 1);
    for (double& v : record) v = value(random);
    for (int i = 0; i < D; ++i) record[RecordPlace<D>::slope + i] = n[i];
  }
  InterfaceSide<double, D> view() const { return {{record.data()}, impedance}; }
  double velocity(const VectorOf<double, D>& n) const {
    double sum = 0;
    for (int i = 0; i < D; ++i) sum += view().surface.velocity(i) * n[i];
    return sum;
  }
  double stress(const VectorOf<double, D>& n) const {
    VectorOf<double, D> s_n;
    return traction<double, D>(view().surface, n, s_n);
  }
};

template <int D>
VectorOf<double, D> negative(VectorOf<double, D> n) {
  for (double& c : n) c = -c;
  return n;
}

template <int D>
VectorOf<double, D> oblique() {
  VectorOf<double, D> n = {0.6, 0.8};
  if constexpr (D == 3) n = {2. / 7, -3. / 7, 6. / 7};
  return n;
}

template <int D>
void expect_opposite_tractions() {
  const VectorOf<double, D> n = oblique<D>();
  for (int trial = 0; trial < 20; ++trial) {
    const Side<D> a(n, 3, 2), b(negative<D>(n), 5, 1);
    for (const auto kind :
         {InterfaceKind::frictionless, InterfaceKind::no_slip, InterfaceKind::tied}) {
      const auto on_a = interface_traction<double, D>(a.view(), b.view(), n, -0.1, kind);
      const auto on_b =
          interface_traction<double, D>(b.view(), a.view(), negative<D>(n), -0.1, kind);
      for (int i = 0; i < D; ++i) {
        EXPECT_NEAR(on_a.normal * on_a.n[i] + on_a.shear[i],
                    -(on_b.normal * on_b.n[i] + on_b.shear[i]), 1e-14);
      }
      EXPECT_TRUE(on_a.normal <= 0 || kind == InterfaceKind::tied);
    }
  }
}

TEST(interface_traction, is_opposite_for_the_two_bodies) {
  expect_opposite_tractions<2>();
  expect_opposite_tractions<3>();
}

// Waves that leave a half space keep their invariant: sigma - Z u below, sigma + Z u above; both
// sides meet with the same velocity.
TEST(interface_traction, solves_the_riemann_problem_of_two_half_spaces) {
  const VectorOf<double, 2> n = oblique<2>();
  for (int trial = 0; trial < 20; ++trial) {
    const Side<2> a(n, 3, 2), b(negative<2>(n), 5, 1);
    const double z_a = a.impedance.pressure_wave, z_b = b.impedance.pressure_wave;
    const double t =
        interface_traction<double, 2>(a.view(), b.view(), n, 0., InterfaceKind::tied).normal;
    const double u_below = a.velocity(n) + (t - a.stress(n)) / z_a;
    const double u_above = b.velocity(n) - (t - b.stress(n)) / z_b;
    EXPECT_NEAR(u_below, u_above, 1e-14);
  }
}

// Coulomb's law is between the two limits: no slip, as long as the pressure is sufficient.
TEST(interface_traction, has_a_shear_of_at_most_the_friction) {
  const VectorOf<double, 3> n = oblique<3>();
  int sliding = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const Side<3> a(n, 3, 2), b(negative<3>(n), 5, 1);
    const auto held =
        interface_traction<double, 3>(a.view(), b.view(), n, -0.5, InterfaceKind::no_slip);
    const auto load =
        interface_traction<double, 3>(a.view(), b.view(), n, -0.5, InterfaceKind::coulomb, 0.3);
    double shear = 0, holding = 0, along = 0;
    for (int i = 0; i < 3; ++i) {
      shear += load.shear[i] * load.shear[i];
      holding += held.shear[i] * held.shear[i];
      along += load.shear[i] * held.shear[i];
    }
    EXPECT_EQ(load.normal, held.normal);
    EXPECT_NEAR(std::sqrt(shear), std::min(std::sqrt(holding), -0.3 * held.normal), 1e-14);
    EXPECT_NEAR(along, std::sqrt(shear * holding), 1e-13);
    sliding += shear < holding ? 1 : 0;
  }
  EXPECT_GT(sliding, 3);
}

// Bodies that approach each other do not push before they touch. Bodies that pressed before keep
// their stress.
TEST(interface_traction, is_none_across_a_gap_unless_the_bodies_are_pressed_or_bonded) {
  const VectorOf<double, 2> n = oblique<2>();
  for (const double pressure : {0., 2.}) {
    Side<2> a(n, 3, 2), b(negative<2>(n), 5, 1);
    for (Side<2>* side : {&a, &b}) {
      for (int i = 0; i < 2; ++i) {
        for (int j = i; j < 2; ++j) {
          side->record[RecordPlace<2>::stress + symmetric_index<2>(i, j)] = i == j ? -pressure : 0.;
        }
        // The bodies approach each other.
        side->record[RecordPlace<2>::velocity + i] = (side == &a ? 1 : -1) * n[i];
      }
    }
    const auto at = [&](InterfaceKind kind, bool touches) {
      return interface_traction<double, 2>(a.view(), b.view(), n, 1e-3, kind, 0., touches).normal;
    };
    EXPECT_LT(at(InterfaceKind::frictionless, true), 0);
    EXPECT_EQ(at(InterfaceKind::frictionless, false) < 0, pressure > 0);
    EXPECT_LT(at(InterfaceKind::tied, false), 0);
  }
}

}  // namespace
}  // namespace pliant::kernels

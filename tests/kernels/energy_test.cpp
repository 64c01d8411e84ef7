#include "kernels/energy.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

namespace pliant::kernels {
namespace {

Material<double> material_of(Model model) {
  Material<double> material;
  material.model = model;
  material.density = 1.5;
  material.bulk_modulus = 80;
  material.shear_modulus = 30;
  material.order = 3;
  material.coefficient = {10, 4, 2, 0, 0};
  material.compressibility = 0.025;
  return material;
}

/// Energy per reference volume at J without deviatoric stress.
double volumetric_energy(const Material<double>& material, double j) {
  const double none[3] = {0, 0, 0};
  return j * linear_energy<double, 2>(material, none, material.density / j);
}

TEST(energy, pressure_is_the_slope_of_the_volumetric_part) {
  const Material<double> rho = material_of(Model::linear);
  const Material<double> log = material_of(Model::linear_logarithmic);
  const double step = 1e-5;
  for (double j = 0.6; j < 1.6; j += 0.05) {
    const auto slope = [&](const Material<double>& m) {
      return (volumetric_energy(m, j + step) - volumetric_energy(m, j - step)) / (2 * step);
    };
    // (RP.5), (RP.6); second-order differences, moduli of 100.
    EXPECT_NEAR(-slope(rho), rho.bulk_modulus * (1 / j - 1), 1e-6);
    EXPECT_NEAR(-slope(log), log.bulk_modulus * std::log(1 / j), 1e-6);
  }
}

TEST(energy, shear_part_is_the_work_of_hookes_law) {
  // S = 2 mu e: the work is e : S/2 = S : S/(4 mu), with S_zz = -(S_xx + S_yy) in plane strain.
  const Material<double> material = material_of(Model::linear);
  const double plane[3] = {3, -2, 5}, space[6] = {3, -2, 0, 5, 0, -8};
  const double square = 9 + 2 * 4 + 25 + 64;
  EXPECT_DOUBLE_EQ((linear_energy<double, 2>(material, plane, material.density)), square / 120);
  EXPECT_DOUBLE_EQ((linear_energy<double, 3>(material, space, material.density)), square / 120);
}

template <int D>
void expect_reduced_polynomial() {
  const Material<double> m = material_of(Model::reduced_polynomial);
  for (int trial = 0; trial < 20; ++trial) {
    Eigen::Matrix3d f = Eigen::Matrix3d::Identity();
    f.topLeftCorner<D, D>() += 0.3 * Eigen::Matrix<double, D, D>::Random();
    double rows[D * D];
    for (int c = 0; c < D * D; ++c) rows[c] = f(c / D, c % D);
    const double j = f.determinant();
    const double excess = std::pow(j, -2. / 3) * (f * f.transpose()).trace() - 3;
    double reference = (j - 1) * (j - 1) / m.compressibility;
    for (int n = 1; n <= 3; ++n) reference += m.coefficient[n - 1] * std::pow(excess, n);
    EXPECT_NEAR((polynomial_energy<double, D>(m, rows)), reference / j, 1e-12 * reference / j);
  }
}

TEST(energy, reduced_polynomial_is_that_of_the_invariants) {
  expect_reduced_polynomial<2>();
  expect_reduced_polynomial<3>();
}

}  // namespace
}  // namespace pliant::kernels

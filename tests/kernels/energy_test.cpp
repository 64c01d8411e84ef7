#include "kernels/energy.hpp"

#include <gtest/gtest.h>

namespace pliant::kernels {
namespace {

Material<double> material_of(Model model) {
  Material<double> material;
  material.model = model;
  material.density = 1.5;
  material.bulk_modulus = 80;
  material.shear_modulus = 30;
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

}  // namespace
}  // namespace pliant::kernels

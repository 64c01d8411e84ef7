#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "kernels/energy.hpp"
#include "kernels/law.hpp"

namespace pliant::kernels {
namespace {

using P = xsimd::batch<double, xsimd::sse2>;
using Deformation = Eigen::Matrix3d;  // in plane strain F_33 = 1

constexpr Model hyperelastic_models[] = {Model::reduced_polynomial, Model::neo_hookean,
                                         Model::st_venant_kirchhoff};

Material<double> tissue(Model model) {
  Material<double> material;
  material.model = model;
  material.bulk_modulus = 40;
  material.shear_modulus = 4.46;
  material.order = 5;
  material.coefficient = {2.23, 7.02, 5.03, 6.19, 7.50};
  material.compressibility = 0.05;
  return material;
}

/// (RP.63), (PB.6) or (PB.7), per undeformed volume.
double energy(const Material<double>& material, const Deformation& f) {
  const double j = f.determinant(), mu = material.shear_modulus;
  const double lambda = material.bulk_modulus - 2. / 3 * mu;
  const Deformation c = f.transpose() * f;
  if (material.model == Model::neo_hookean) {
    return mu / 2 * (c.trace() - 3) - mu * std::log(j) + lambda / 2 * (j - 1) * (j - 1);
  }
  if (material.model == Model::st_venant_kirchhoff) {
    const Deformation e = (c - Deformation::Identity()) / 2;
    return lambda / 2 * e.trace() * e.trace() + mu * e.squaredNorm();
  }
  const double excess = std::pow(j, -2. / 3) * c.trace() - 3;
  double w = (j - 1) * (j - 1) / material.compressibility;
  for (int n = 1; n <= material.order; ++n) {
    w += material.coefficient[n - 1] * std::pow(excess, n);
  }
  return w;
}

/// dW/dF by central differences of fourth order.
Deformation nominal_stress(const Material<double>& material, const Deformation& f) {
  const double step = 1e-3;
  Deformation stress;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const auto w = [&](double by) {
        Deformation moved = f;
        moved(i, j) += by * step;
        return energy(material, moved);
      };
      stress(i, j) = (8 * (w(1) - w(-1)) - (w(2) - w(-2))) / (12 * step);
    }
  }
  return stress;
}

template <int D>
Deformation random_deformation(double amount) {
  Deformation f = Deformation::Identity();
  f.topLeftCorner<D, D>() += amount * Eigen::Matrix<double, D, D>::Random();
  return f;
}

template <int D>
void pack_deformation(const Deformation& f, P (&packed)[D * D]) {
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) packed[i * D + j] = P(f(i, j));
  }
}

template <Model model, int D>
void expect_stress_of_the_energy() {
  using L = Law<model, P, D>;
  const Material<double> material = tissue(model);
  for (int trial = 0; trial < 50; ++trial) {
    const Deformation f = random_deformation<D>(0.2);
    P packed[D * D], sigma[symmetric_components<D>];
    pack_deformation<D>(f, packed);
    L::stress(material, packed, P(1.), sigma);
    const Deformation expected = nominal_stress(material, f) * f.transpose() / f.determinant();
    // Fourth-order differences: step^4 = 1e-12 times fifth derivatives of order 1e3..1e4.
    const double tolerance = 2e-7 * (1 + expected.norm());
    for (int i = 0; i < D; ++i) {
      for (int j = i; j < D; ++j) {
        EXPECT_NEAR(sigma[symmetric_index<D>(i, j)].get(0), expected(i, j), tolerance);
      }
    }
    if (model == Model::reduced_polynomial) continue;
    EXPECT_NEAR(L::pressure(material, packed, P(1.)).get(0), -expected.trace() / 3, tolerance);
  }
}

template <Model model>
void expect_law() {
  expect_stress_of_the_energy<model, 2>();
  expect_stress_of_the_energy<model, 3>();
  // Moduli of 50 times the rounding of J and of the cube root.
  P f[4] = {P(1.), P(0.), P(0.), P(1.)}, sigma[3];
  Law<model, P, 2>::stress(tissue(model), f, P(1.), sigma);
  for (const P& component : sigma) EXPECT_NEAR(component.get(0), 0, 1e-14);
}

TEST(hyperelastic_laws, stresses_are_the_derivatives_of_the_energies) {
  expect_law<Model::reduced_polynomial>();
  expect_law<Model::neo_hookean>();
  expect_law<Model::st_venant_kirchhoff>();
}

template <int D>
void expect_energies() {
  for (const Model model : hyperelastic_models) {
    const Material<double> material = tissue(model);
    for (int trial = 0; trial < 20; ++trial) {
      const Deformation f = random_deformation<D>(0.3);
      double rows[D * D];
      for (int c = 0; c < D * D; ++c) rows[c] = f(c / D, c % D);
      const double reference = energy(material, f);
      EXPECT_NEAR((hyperelastic_energy<double, D>(material, rows)), reference, 1e-12 * reference);
    }
  }
}

TEST(hyperelastic_laws, energies_are_those_of_the_invariants) {
  expect_energies<2>();
  expect_energies<3>();
}

template <int D>
void expect_deformation_rate_of_motion() {
  const Eigen::Matrix<double, D, D> f = Eigen::Matrix<double, D, D>::Random();
  const Eigen::Matrix<double, D, D> g = Eigen::Matrix<double, D, D>::Random();
  P packed[D * D], gradient[D][D], rate[D * D];
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) {
      packed[i * D + j] = P(f(i, j));
      gradient[i][j] = P(g(i, j));
    }
  }
  deformation_rate<P, D>(packed, gradient, rate);
  // Homogeneous motion x(X, t) = (I + t G) F X, so that du/dx = G at t = 0.
  const double step = 0.5;  // F is linear in t: the difference is exact
  const Eigen::Matrix<double, D, D> ahead = f + step * g * f, behind = f - step * g * f;
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) {
      EXPECT_NEAR(rate[i * D + j].get(0), (ahead(i, j) - behind(i, j)) / (2 * step), 1e-14);
    }
  }
}

TEST(hyperelastic_laws, deformation_rate_is_that_of_an_exact_motion) {
  expect_deformation_rate_of_motion<2>();
  expect_deformation_rate_of_motion<3>();
}

/// Largest rho c^2 of plane waves along random normals: eigenvalues of the acoustic tensor Q_ik =
/// n_j n_l F_jJ F_lL d^2W/dF_iJ dF_kL / J, by differences of the energy along a (x) F^T n. In 2D
/// normals and motions are those in the plane.
template <int D>
double largest_modulus(const Material<double>& material, const Deformation& f) {
  const double step = 1e-3;
  double largest = 0;
  for (int trial = 0; trial < 40; ++trial) {
    Eigen::Vector3d n = Eigen::Vector3d::Zero();
    n.head<D>() = Eigen::Matrix<double, D, 1>::Random().normalized();
    const Eigen::Vector3d m = f.transpose() * n;
    const auto w = [&](const Eigen::Vector3d& a) {
      return energy(material, f + step * a * m.transpose());
    };
    const double centre = w(Eigen::Vector3d::Zero());
    Eigen::Matrix<double, D, D> q;
    for (int i = 0; i < D; ++i) {
      for (int k = 0; k < D; ++k) {
        const Eigen::Vector3d a = Eigen::Vector3d::Unit(i), b = Eigen::Vector3d::Unit(k);
        q(i, k) =
            i == k ? (w(a) + w(-a) - 2 * centre) : (w(a + b) + w(-a - b) - w(a - b) - w(b - a)) / 4;
      }
    }
    q /= step * step * f.determinant();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, D, D>> solver(q);
    largest = std::max(largest, solver.eigenvalues()[D - 1]);
  }
  return largest;
}

template <Model model, int D>
double bound(const Material<double>& material, const Deformation& f) {
  P packed[D * D];
  pack_deformation<D>(f, packed);
  const P density(material.density / f.determinant());
  return (Law<model, P, D>::wave_speed2(material, packed, density) * density).get(0);
}

template <Model model, int D>
void expect_bounded_wave_speeds() {
  const Material<double> material = tissue(model);
  for (int trial = 0; trial < 50; ++trial) {
    const Deformation f = random_deformation<D>(0.4);
    if (f.determinant() < 0.3) continue;
    // The error of second differences is step^2 times fourth derivatives: below a thousandth.
    EXPECT_LT(largest_modulus<D>(material, f), 1.001 * (bound<model, D>(material, f)));
  }
}

TEST(hyperelastic_laws, wave_speeds_bound_the_acoustic_tensor) {
  using enum Model;
  expect_bounded_wave_speeds<reduced_polynomial, 2>();
  expect_bounded_wave_speeds<reduced_polynomial, 3>();
  expect_bounded_wave_speeds<neo_hookean, 2>();
  expect_bounded_wave_speeds<neo_hookean, 3>();
  expect_bounded_wave_speeds<st_venant_kirchhoff, 2>();
  expect_bounded_wave_speeds<st_venant_kirchhoff, 3>();
  // At rest the bound of the polynomial is K + 10/3 C10 where the exact modulus is K + 8/3 C10.
  const auto at_rest = [](Model model) {
    const Deformation one = Deformation::Identity();
    return model == neo_hookean ? bound<neo_hookean, 2>(tissue(model), one)
                                : bound<st_venant_kirchhoff, 2>(tissue(model), one);
  };
  EXPECT_DOUBLE_EQ(
      (bound<reduced_polynomial, 2>(tissue(reduced_polynomial), Deformation::Identity())),
      40 + 10 * 2.23 / 3);
  EXPECT_DOUBLE_EQ(at_rest(neo_hookean), 40 + 8 * 2.23 / 3);
  EXPECT_DOUBLE_EQ(at_rest(st_venant_kirchhoff), 40 + 8 * 2.23 / 3);
}

TEST(hyperelastic_laws, impossible_deformations_of_the_polynomial_are_not_finite) {
  P f[4] = {P(-1.), P(0.), P(0.), P(1.)}, sigma[3];
  Law<Model::reduced_polynomial, P, 2>::stress(tissue(Model::reduced_polynomial), f, P(1.), sigma);
  EXPECT_TRUE(std::isnan(sigma[0].get(0)));
}

}  // namespace
}  // namespace pliant::kernels

#include "kernels/reduced_polynomial.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <functional>

#include "kernels/law.hpp"

namespace pliant::kernels {
namespace {

using P = xsimd::batch<double, xsimd::sse2>;
using Deformation = Eigen::Matrix3d;  // in plane strain F_33 = 1

Material<double> liver() {
  Material<double> material;
  material.model = Model::reduced_polynomial;
  material.order = 5;
  material.coefficient = {2.23, 7.02, 5.03, 6.19, 7.50};
  material.compressibility = 0.05;
  return material;
}

/// (RP.63), per reference volume.
double energy(const Material<double>& material, const Deformation& f) {
  const double j = f.determinant();
  const double excess = std::pow(j, -2. / 3) * (f * f.transpose()).trace() - 3;
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

template <int D>
void expect_stress_of_the_energy() {
  const Material<double> material = liver();
  for (int trial = 0; trial < 50; ++trial) {
    const Deformation f = random_deformation<D>(0.2);
    P packed[D * D], sigma[symmetric_components<D>];
    pack_deformation<D>(f, packed);
    Law<Model::reduced_polynomial, P, D>::stress(material, packed, P(1.), sigma);
    const Deformation expected = nominal_stress(material, f) * f.transpose() / f.determinant();
    for (int i = 0; i < D; ++i) {
      for (int j = i; j < D; ++j) {
        // Fourth-order differences: step^4 = 1e-12 times fifth derivatives of order 1e3..1e4.
        EXPECT_NEAR(sigma[symmetric_index<D>(i, j)].get(0), expected(i, j),
                    2e-7 * (1 + expected.norm()));
      }
    }
  }
}

TEST(reduced_polynomial, stress_is_the_derivative_of_the_energy) {
  expect_stress_of_the_energy<2>();
  expect_stress_of_the_energy<3>();
}

TEST(reduced_polynomial, reference_state_is_free_of_stress) {
  P f[4] = {P(1.), P(0.), P(0.), P(1.)}, sigma[3];
  Law<Model::reduced_polynomial, P, 2>::stress(liver(), f, P(1.), sigma);
  // 2 W1/J = 4.5 times the rounding of the cube root.
  for (const P& component : sigma) EXPECT_NEAR(component.get(0), 0, 1e-14);
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

TEST(reduced_polynomial, deformation_rate_is_that_of_an_exact_motion) {
  expect_deformation_rate_of_motion<2>();
  expect_deformation_rate_of_motion<3>();
}

/// Largest rho c^2 of plane waves along random normals: eigenvalues of the acoustic tensor Q_ik =
/// n_j n_l F_jJ F_lL d^2W/dF_iJ dF_kL / J, by differences of the energy along a (x) F^T n.
double largest_modulus(const Material<double>& material, const Deformation& f) {
  const double step = 1e-3;
  double largest = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const Eigen::Vector3d m = f.transpose() * Eigen::Vector3d::Random().normalized();
    const auto w = [&](const Eigen::Vector3d& a) {
      return energy(material, f + step * a * m.transpose());
    };
    const double centre = w(Eigen::Vector3d::Zero());
    Eigen::Matrix3d q;
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d a = Eigen::Vector3d::Unit(i), b = Eigen::Vector3d::Unit(k);
        q(i, k) =
            i == k ? (w(a) + w(-a) - 2 * centre) : (w(a + b) + w(-a - b) - w(a - b) - w(b - a)) / 4;
      }
    }
    q /= step * step * f.determinant();
    largest = std::max(largest, Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(q).eigenvalues()[2]);
  }
  return largest;
}

template <int D>
double bound(const Material<double>& material, const Deformation& f) {
  P packed[D * D];
  pack_deformation<D>(f, packed);
  const P density(material.density / f.determinant());
  return (Law<Model::reduced_polynomial, P, D>::wave_speed2(material, packed, density) * density)
      .get(0);
}

TEST(reduced_polynomial, wave_speed_bounds_the_acoustic_tensor) {
  const Material<double> material = liver();
  for (int trial = 0; trial < 50; ++trial) {
    const Deformation plane = random_deformation<2>(0.4), space = random_deformation<3>(0.4);
    // The error of second differences is step^2 times fourth derivatives: below a thousandth.
    if (plane.determinant() > 0.3) {
      EXPECT_LT(largest_modulus(material, plane), 1.001 * bound<2>(material, plane));
    }
    if (space.determinant() > 0.3) {
      EXPECT_LT(largest_modulus(material, space), 1.001 * bound<3>(material, space));
    }
  }
  // At rest the bound is K + 10/3 C10 where the exact modulus is K + 8/3 C10.
  EXPECT_DOUBLE_EQ(bound<2>(material, Deformation::Identity()), 2 / 0.05 + 10 * 2.23 / 3);
}

TEST(reduced_polynomial, impossible_deformations_are_not_finite) {
  P f[4] = {P(-1.), P(0.), P(0.), P(1.)}, sigma[3];
  Law<Model::reduced_polynomial, P, 2>::stress(liver(), f, P(1.), sigma);
  EXPECT_TRUE(std::isnan(sigma[0].get(0)));
}

}  // namespace
}  // namespace pliant::kernels

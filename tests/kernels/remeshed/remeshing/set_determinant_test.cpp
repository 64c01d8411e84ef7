#include "kernels/remeshed/remeshing/set_determinant.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace pliant::kernels {
namespace {

template <int D>
using Matrix = Eigen::Matrix<double, D, D, Eigen::RowMajor>;

template <int D>
Matrix<D> random_matrix(std::mt19937& generator) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  return Matrix<D>::NullaryExpr([&] { return uniform(generator); });
}

template <int D>
std::array<double, D * D> entries(const Matrix<D>& m) {
  std::array<double, D * D> f;
  std::copy(m.data(), m.data() + D * D, f.begin());
  return f;
}

template <int D>
void expect_determinant_and_least_change() {
  std::mt19937 generator(7);
  for (int sample = 0; sample < 200; ++sample) {
    Matrix<D> f = Matrix<D>::Identity() + 0.3 * random_matrix<D>(generator);
    f(0, 1) += 0.1 * sample;  // up to a shear of 20
    const double value = 1 + 0.002 * sample;
    auto changed = entries<D>(f);
    set_determinant<double, D>(changed, value);
    const Eigen::Map<Matrix<D>> g(changed.data());
    EXPECT_NEAR(g.determinant(), value, 1e-12);
    // To first order the change is along the cofactors, with no component along the constraint.
    const Matrix<D> cofactor = g.determinant() * g.inverse().transpose();
    const Matrix<D> change = g - f;
    const Matrix<D> along =
        (change.cwiseProduct(cofactor).sum() / cofactor.squaredNorm()) * cofactor;
    EXPECT_LE((change - along).norm(), change.norm() * change.norm() * 3 + 1e-12);
  }
}

TEST(set_determinant, changes_a_matrix_as_little_as_it_can) {
  expect_determinant_and_least_change<2>();
  expect_determinant_and_least_change<3>();
}

TEST(set_determinant, turns_an_inverted_matrix_back) {
  std::array<double, 4> sheared = {1, 12, 0.01, 0.1};
  set_determinant<double, 2>(sheared, 0.9);
  EXPECT_NEAR(sheared[0] * sheared[3] - sheared[1] * sheared[2], 0.9, 1e-13);
  EXPECT_NEAR(sheared[1], 12, 0.02);
}

TEST(set_determinant, leaves_what_has_it) {
  const std::array<double, 4> f = {1, 3, 0, 1};
  auto same = f;
  set_determinant<double, 2>(same, 1);
  EXPECT_EQ(same, f);
}

TEST(set_determinant, cofactors_are_those_of_the_inverse) {
  std::mt19937 generator(3);
  const Matrix<3> f = random_matrix<3>(generator);
  const Matrix<3> expected = f.determinant() * f.inverse().transpose();
  const auto found = cofactors(entries<3>(f));
  for (int c = 0; c < 9; ++c) EXPECT_NEAR(found[c], expected.data()[c], 1e-15);
}

}  // namespace
}  // namespace pliant::kernels

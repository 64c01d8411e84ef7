#include "kernels/remeshed/stage/moment.hpp"

#include <gtest/gtest.h>

#include <random>

namespace pliant::kernels {
namespace {

using P = xsimd::batch<double, xsimd::sse2>;

/// Largest component of abs(A A^-1 - I) for random positive definite A = B B^T + I/10.
template <int D>
double worst_product(std::mt19937& random) {
  std::uniform_real_distribution<double> entry(-1, 1);
  double b[D][D], dense[D][D];
  for (auto& row : b) {
    for (double& x : row) x = entry(random);
  }
  P a[symmetric_components<D>], inverse[symmetric_components<D>];
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) {
      dense[i][j] = i == j ? 0.1 : 0;
      for (int k = 0; k < D; ++k) dense[i][j] += b[i][k] * b[j][k];
      a[symmetric_index<D>(i, j)] = P(dense[i][j]);
    }
  }
  invert_symmetric(a, inverse);
  double worst = 0;
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) {
      double product = i == j ? -1 : 0;
      for (int k = 0; k < D; ++k) {
        product += dense[i][k] * inverse[symmetric_index<D>(k, j)].get(0);
      }
      worst = std::max(worst, std::abs(product));
    }
  }
  return worst;
}

TEST(moment, times_its_inverse_is_the_identity) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 100; ++trial) {
    // The condition number of these matrices is below 100, and that of the cofactors its square.
    EXPECT_LT(worst_product<2>(random), 1e-12);
    EXPECT_LT(worst_product<3>(random), 1e-12);
  }
}

}  // namespace
}  // namespace pliant::kernels

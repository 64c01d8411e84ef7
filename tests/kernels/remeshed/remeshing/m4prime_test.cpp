#include "kernels/remeshed/remeshing/m4prime.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pliant::kernels {
namespace {

using P = xsimd::batch<double, xsimd::sse2>;

/// sum_k (x_k - x)^degree M4'(x_k - x) over the four nodes, with h = 1.
double moment(double fraction, int degree) {
  P weight[4];
  m4prime(P(fraction), weight);
  double sum = 0;
  for (int k = 0; k < 4; ++k) sum += std::pow(k - 1 - fraction, degree) * weight[k].get(0);
  return sum;
}

TEST(m4prime, reproduces_polynomials_of_degree_two) {
  for (double x = 0; x < 1; x += 0.01) {
    EXPECT_NEAR(moment(x, 0), 1, 1e-15);
    EXPECT_NEAR(moment(x, 1), 0, 1e-15);
    EXPECT_NEAR(moment(x, 2), 0, 1e-15);
  }
}

TEST(m4prime, has_the_third_moment_of_its_documentation) {
  for (double x = 0; x < 1; x += 0.01) {
    EXPECT_NEAR(moment(x, 3), x * (1 - x) * (1 - 2 * x), 1e-14);
  }
}

TEST(m4prime, interpolates_at_nodes) {
  P weight[4];
  m4prime(P(0.), weight);
  EXPECT_EQ(weight[0].get(0), 0);
  EXPECT_EQ(weight[1].get(0), 1);
  EXPECT_EQ(weight[2].get(0), 0);
  EXPECT_EQ(weight[3].get(0), 0);
}

}  // namespace
}  // namespace pliant::kernels

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "engine/total_lagrangian/stress_point.hpp"
#include "tests/engine/total_lagrangian/blocks.hpp"

// (TL.22)
namespace pliant::test {
namespace {

/// sigma and psi of (PB.6) or (PB.7), written independently for E = 30 and nu = 0.3.
struct StressAndEnergy {
  Eigen::Matrix3d sigma;
  double energy;
};

StressAndEnergy law_by_hand(bool is_neo_hookean, const Eigen::Matrix3d& f) {
  const double mu = 30 / 2.6, lambda = 30 * 0.3 / (1.3 * 0.4), j = f.determinant();
  const Eigen::Matrix3d one = Eigen::Matrix3d::Identity();
  if (is_neo_hookean) {
    const Eigen::Matrix3d b = f * f.transpose();
    return {mu / j * (b - one) + lambda * (j - 1) * one,
            mu / 2 * (b.trace() - 3) - mu * std::log(j) + lambda / 2 * (j - 1) * (j - 1)};
  }
  const Eigen::Matrix3d e = (f.transpose() * f - one) / 2;
  return {f * (lambda * e.trace() * one + 2 * mu * e) * f.transpose() / j,
          lambda / 2 * e.trace() * e.trace() + mu * e.squaredNorm()};
}

template <class Dimension>
struct Laws : testing::Test {};

using PlaneAndSolid =
    testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Laws, PlaneAndSolid);

TYPED_TEST(Laws, of_all_methods_on_the_undeformed_body_have_their_closed_forms) {
  constexpr int D = TypeParam::value;
  Eigen::Matrix3d some;
  some << 1.2, 0.3, -0.1, -0.2, 0.9, 0.15, 0.05, -0.25, 1.1;
  const Eigen::Matrix<double, D, D> f = some.topLeftCorner<D, D>();
  Eigen::Matrix3d full = Eigen::Matrix3d::Identity();
  full.topLeftCorner<D, D>() = f;
  for (const std::string law : {"neo_hookean", "st_venant_kirchhoff"}) {
    LagrangianSolver<D> block(tests::read_text(block_of_law(D, law)),
                              {1, kernels::widest_supported()});
    auto& body = block.state().bodies[0];
    for_each_particle<D>(body, [&](std::int64_t p, const Point<D>& x) {
      for (int i = 0; i < D; ++i) {
        body.displacement[i][p] = -x[i];
        for (int j = 0; j < D; ++j) body.displacement[i][p] += f(i, j) * x[j];
      }
    });
    const StressAndEnergy exact = law_by_hand(law == "neo_hookean", full);
    for (const Block<D>& range : body.layout.blocks()) {
      body.layout.for_each_slot(range, [&](std::int64_t p, const Cell<D>& cell) {
        if (!(body.fraction[p] > 0)) return;
        const auto point = total_lagrangian::stress_point<double, D>(body, p, cell);
        for (int i = 0; i < D; ++i) {
          for (int k = i; k < D; ++k) {
            EXPECT_NEAR(point.stress[kernels::symmetric_index<D>(i, k)], exact.sigma(i, k), 1e-11);
          }
        }
        EXPECT_NEAR(point.pressure, -exact.sigma.trace() / 3, 1e-11);
      });
    }
    EXPECT_NEAR(block.integrals().strain_energy, exact.energy, 1e-11);
  }
}

}  // namespace
}  // namespace pliant::test

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "engine/total_lagrangian/stress_point.hpp"
#include "tests/engine/total_lagrangian/blocks.hpp"

namespace pliant::test {
namespace {

template <class Dimension>
struct StressPoints : testing::Test {
  static constexpr int dimension = Dimension::value;
  using Matrix = Eigen::Matrix<double, dimension, dimension>;

  StressPoints()
      : solver(tests::read_text(free_block(dimension)), {1, kernels::widest_supported()}) {}

  auto& body() { return solver.state().bodies[0]; }

  void deform(const Matrix& f) {
    for_each_particle<dimension>(body(), [&](std::int64_t p, const Point<dimension>& x) {
      for (int i = 0; i < dimension; ++i) {
        body().displacement[i][p] = -x[i];
        for (int j = 0; j < dimension; ++j) body().displacement[i][p] += f(i, j) * x[j];
      }
    });
  }

  /// A step so short that only forces count.
  void weigh() { solver.step(1e-9); }

  LagrangianSolver<dimension> solver;
};

using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(StressPoints, Dimensions);

template <int D>
Eigen::Matrix<double, D, D> some_deformation() {
  Eigen::Matrix3d f;
  f << 1.2, 0.3, -0.1, -0.2, 0.9, 0.15, 0.05, -0.25, 1.1;
  return f.topLeftCorner<D, D>();
}

TYPED_TEST(StressPoints, a_homogeneous_deformation_has_the_stress_of_the_law_everywhere) {
  constexpr int D = TypeParam::value;
  const auto f = some_deformation<D>();
  this->deform(f);
  // (RP.9), (RP.11) written out anew.
  Eigen::Matrix3d full = Eigen::Matrix3d::Identity();
  full.topLeftCorner<D, D>() = f;
  const double j = full.determinant();
  const Eigen::Matrix3d b = std::pow(j, -2. / 3) * full * full.transpose();
  const Eigen::Matrix3d dev = b - b.trace() / 3 * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d sigma = 2 / j * 10 * dev + 2 / 0.05 * (j - 1) * Eigen::Matrix3d::Identity();
  const double energy = 10 * (b.trace() - 3) + (j - 1) * (j - 1) / 0.05;
  const auto& body = this->body();
  double sum = 0;
  for (const Block<D>& block : body.layout.blocks()) {
    body.layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
      if (!(body.fraction[p] > 0)) return;
      const auto point = total_lagrangian::stress_point<double, D>(body, p, cell, 1);
      EXPECT_NEAR(point.volume_ratio, j, 1e-12);
      for (int i = 0; i < D; ++i) {
        for (int k = i; k < D; ++k) {
          EXPECT_NEAR(point.stress[kernels::symmetric_index<D>(i, k)], sigma(i, k), 1e-10);
        }
      }
      sum += point.energy;
    });
  }
  EXPECT_NEAR(sum, energy, 1e-11);
}

TYPED_TEST(StressPoints, a_homogeneous_deformation_pulls_on_faces_only) {
  constexpr int D = TypeParam::value;
  this->deform(some_deformation<D>());
  this->weigh();
  double total[D] = {}, largest = 0;
  for_each_particle<D>(this->body(), [&](std::int64_t p, const Point<D>& x) {
    bool inside = true;
    for (int a = 0; a < D; ++a) inside = inside && x[a] > 0.01 && x[a] < 0.99;
    for (int i = 0; i < D; ++i) {
      const double force = this->body().internal[i][p];
      total[i] += force;
      if (inside) {
        EXPECT_NEAR(force, 0, 1e-12);
      }
      largest = std::max(largest, std::abs(force));
    }
  });
  EXPECT_GT(largest, 0.01);
  for (const double sum : total) EXPECT_NEAR(sum, 0, 1e-12);
}

TYPED_TEST(StressPoints, a_turned_body_feels_nothing) {
  constexpr int D = TypeParam::value;
  Eigen::Matrix<double, D, D> turn;
  if constexpr (D == 2) {
    turn = Eigen::Rotation2Dd(2).toRotationMatrix();
  } else {
    turn = Eigen::AngleAxisd(2, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  }
  this->deform(turn);
  this->weigh();
  for_each_particle<D>(this->body(), [&](std::int64_t p, const Point<D>&) {
    for (int i = 0; i < D; ++i) EXPECT_NEAR(this->body().internal[i][p], 0, 1e-12);
  });
}

// A cell bent so that its middle does not notice.
TYPED_TEST(StressPoints, an_hourglass_is_resisted_with_the_force_of_its_energy) {
  constexpr int D = TypeParam::value;
  auto& body = this->body();
  const auto wave = [&](double amplitude) {
    for_each_particle<D>(body, [&](std::int64_t p, const Point<D>& x) {
      double sign = 1;
      for (int a = 0; a < D; ++a) sign *= std::lround(x[a] / 0.125) % 2 == 0 ? 1 : -1;
      body.displacement[0][p] = amplitude * sign;
    });
  };
  const auto energy = [&](double amplitude) {
    wave(amplitude);
    return this->solver.integrals().strain_energy;
  };
  const double step = 1e-6;
  const double slope = (energy(0.01 + step) - energy(0.01 - step)) / (2 * step);
  wave(0.01);
  this->weigh();
  double work = 0;
  for_each_particle<D>(body, [&](std::int64_t p, const Point<D>& x) {
    double sign = 1;
    for (int a = 0; a < D; ++a) sign *= std::lround(x[a] / 0.125) % 2 == 0 ? 1 : -1;
    work += body.internal[0][p] * sign;
  });
  EXPECT_GT(slope, 0.1);
  EXPECT_NEAR(work, -slope, 1e-7 * slope);
}

// With a stiffening material, stretched: what the energy holds is what the particles feel.
TEST(hourglass, is_resisted_with_the_force_of_its_energy_under_stretch_too) {
  LagrangianSolver<2> solver(
      tests::read_text(free_block(2), {"material.rubber.coefficients=[10, 30]"}),
      {1, kernels::widest_supported()});
  auto& body = solver.state().bodies[0];
  const auto sign = [](const Point<2>& x) {
    return (std::lround(x[0] / 0.125) + std::lround(x[1] / 0.125)) % 2 == 0 ? 1. : -1.;
  };
  const auto energy = [&](double amplitude) {
    for_each_particle<2>(body, [&](std::int64_t p, const Point<2>& x) {
      body.displacement[0][p] = 0.4 * x[0] + amplitude * sign(x);
      body.displacement[1][p] = -0.2 * x[1];
    });
    return solver.integrals().strain_energy;
  };
  const double step = 1e-6;
  const double slope = (energy(0.01 + step) - energy(0.01 - step)) / (2 * step);
  energy(0.01);
  solver.step(1e-9);
  double work = 0;
  for_each_particle<2>(
      body, [&](std::int64_t p, const Point<2>& x) { work += body.internal[0][p] * sign(x); });
  EXPECT_GT(slope, 0.1);
  EXPECT_NEAR(work, -slope, 1e-6 * slope);
}

}  // namespace
}  // namespace pliant::test

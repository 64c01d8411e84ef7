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

  /// Takes a step so short that only forces matter.
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
  // (RP.9), (RP.11) written independently.
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
      const auto point = total_lagrangian::stress_point<double, D>(body, p, cell);
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

// A cell in an hourglass mode, of which its middle sees no strain.
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

/// A wall that ends on the upper face of the block, between particles.
std::string collar(int dimension) {
  const std::string box =
      R"({ shape = "difference", of = [{ shape = "box", lower = [-9, 1], upper = [9, 9] },
                                       { shape = "box", lower = [0.43, -9], upper = [9, 9] }] })";
  const std::string hole =
      R"({ shape = "difference", of = [{ shape = "half_space", point = [0, 0, 1], normal = [0, 0, -1] },
  { shape = "cylinder", centre = [0.47, 0.52, 0], axis = [0, 0, 1], radius = 0.31 }] })";
  return "[[boundary]]\nname = \"collar\"\nkind = \"fixed\"\ngeometry = " +
         (dimension == 2 ? box : hole) + "\n";
}

const std::string linear_rubber =
    "{ model = \"linear\", youngs_modulus = 30, poissons_ratio = 0.3, density = 1 }";

/// The block without what lies outside a disc or a ball: the surface cuts its cells.
std::string rounded(const std::string& block, int dimension) {
  const std::string box = dimension == 2
                              ? R"({ shape = "box", lower = [0, 0], upper = [1, 1] })"
                              : R"({ shape = "box", lower = [0, 0, 0], upper = [1, 1, 1] })";
  const std::string round = dimension == 2
                                ? R"({ shape = "disc", centre = [0.4, 0.45], radius = 0.6 })"
                                : R"({ shape = "ball", centre = [0.4, 0.45, 0.5], radius = 0.6 })";
  return tests::with(block, box, "{ shape = \"intersection\", of = [" + box + ", " + round + "] }");
}

/// Blocks of every law, free and below a collar, whole and rounded; the last ones viscous in shear.
std::vector<std::string> blocks_of_every_law(int dimension) {
  const std::string free = free_block(dimension), named = "material = \"rubber\"";
  const std::string linear = tests::with(free, named, "material = " + linear_rubber);
  const std::string logarithmic =
      tests::with(linear, "density = 1 }", "density = 1, equation_of_state = \"logarithmic\" }");
  const std::string stiffening = tests::with(free, "[10]", "[10, 30, 20, 10, 5]");
  const std::string neo_hookean = block_of_law(dimension, "neo_hookean");
  const std::string viscous = tests::with(
      stiffening, "0.05\n", "0.05\nprony_shear = { ratios = [0.3, 0.4], times = [1e9, 1e10] }\n");
  return {free,
          stiffening,
          linear,
          logarithmic,
          stiffening + collar(dimension),
          neo_hookean,
          neo_hookean + collar(dimension),
          block_of_law(dimension, "st_venant_kirchhoff"),
          rounded(stiffening, dimension),
          rounded(neo_hookean, dimension) + collar(dimension),
          viscous + collar(dimension),
          rounded(viscous, dimension) + collar(dimension)};
}

// Large strains with hourglass modes: forces are the derivatives of the energy.
TYPED_TEST(StressPoints, forces_are_the_derivatives_of_the_energy) {
  constexpr int D = TypeParam::value;
  for (const std::string& text : blocks_of_every_law(D)) {
    LagrangianSolver<D> block(tests::read_text(text, {"discretisation.spacing=0.25"}),
                              {1, kernels::widest_supported()});
    auto& body = block.state().bodies[0];
    // Networks with arbitrary memory, which they keep.
    for (std::size_t c = 0; c < body.network.size(); ++c) {
      for (std::int64_t p = 0; p < body.layout.slots(); ++p) {
        body.network[c][p] = 0.2 * std::sin(3. * static_cast<double>(p + 7 * c));
      }
    }
    const auto deform = [&] {
      for_each_particle<D>(body, [&](std::int64_t p, const Point<D>& x) {
        for (int i = 0; i < D; ++i) {
          body.displacement[i][p] = 0.1 * x[i] + 0.03 * std::sin(40. * static_cast<double>(p) + i);
        }
      });
    };
    deform();
    block.step(HUGE_VAL);
    std::array<std::vector<double>, D> force;
    for (int i = 0; i < D; ++i) {
      force[i].assign(body.internal[i].get(), body.internal[i].get() + body.layout.slots());
    }
    deform();
    double largest = 0;
    for_each_particle<D>(body, [&](std::int64_t p, const Point<D>&) {
      for (int i = 0; i < D; ++i) {
        constexpr double step = 1e-6;
        const double at = body.displacement[i][p];
        body.displacement[i][p] = at + step;
        const double above = block.integrals().strain_energy;
        body.displacement[i][p] = at - step;
        const double below = block.integrals().strain_energy;
        body.displacement[i][p] = at;
        EXPECT_NEAR(force[i][p], -(above - below) / (2 * step), 1e-7) << p << " " << i;
        largest = std::max(largest, std::abs(force[i][p]));
      }
    });
    EXPECT_GT(largest, 0.1);
  }
}

// Cells that are fitted to the rim of a wall are no longer regular.
TYPED_TEST(StressPoints, linear_displacements_give_fitted_cells_the_stress_of_all_others) {
  constexpr int D = TypeParam::value;
  LagrangianSolver<D> block(tests::read_text(free_block(D) + collar(D)),
                            {1, kernels::widest_supported()});
  auto& body = block.state().bodies[0];
  EXPECT_GT(body.fitted.size(), D == 2 ? 3u : 50u);
  const auto f = some_deformation<D>();
  for_each_particle<D>(body, [&](std::int64_t p, const Point<D>& x) {
    for (int i = 0; i < D; ++i) {
      body.displacement[i][p] = -x[i];
      for (int j = 0; j < D; ++j) body.displacement[i][p] += f(i, j) * x[j];
    }
  });
  double volume = 0;
  std::vector<double> first;
  for (const Block<D>& range : body.layout.blocks()) {
    body.layout.for_each_slot(range, [&](std::int64_t p, const Cell<D>& cell) {
      if (!(body.fraction[p] > 0)) return;
      const auto point = total_lagrangian::stress_point<double, D>(body, p, cell);
      volume += point.volume;
      const std::vector<double> stress(point.stress.begin(), point.stress.end());
      if (first.empty()) first = stress;
      for (std::size_t c = 0; c < stress.size(); ++c) EXPECT_NEAR(stress[c], first[c], 1e-11);
      EXPECT_NEAR(point.volume_ratio, f.determinant(), 1e-13);
    });
  }
  EXPECT_NEAR(volume, 1, 1e-3);  // the error is of second order in the distortion of cells
  EXPECT_NEAR(block.integrals().mass, volume, 1e-12);
  block.step(HUGE_VAL);
  double inside = 0, largest = 0;
  for_each_particle<D>(body, [&](std::int64_t p, const Point<D>& x) {
    bool is_inside = true;
    for (int a = 0; a < D; ++a) is_inside = is_inside && x[a] > 0.01 && x[a] < 0.99;
    for (int i = 0; i < D; ++i) {
      largest = std::max(largest, std::abs(body.internal[i][p]));
      if (is_inside) inside = std::max(inside, std::abs(body.internal[i][p]));
    }
  });
  // One point integrates the gradient exactly over any quadrilateral; over a hexahedron whose edges
  // are not parallel the error is the square of its distortion of about 0.1.
  EXPECT_LT(inside, (D == 2 ? 1e-12 : 0.01) * largest);
}

}  // namespace
}  // namespace pliant::test

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <numeric>

#include "engine/point_based/forces/node_state.hpp"
#include "tests/engine/point_based/blocks.hpp"
#include "tests/engine/point_based/deformations.hpp"
#include "tests/engine/undeformed/forces.hpp"

// Forces of the point-based method, compared with its energy and its invariants.
namespace pliant::test {
namespace {

using point_based::Body;
using point_based::NodeBlock;

template <class Dimension>
struct PointForces : testing::Test {
  static constexpr int dimension = Dimension::value;
  using Matrix = Eigen::Matrix<double, dimension, dimension>;

  static std::string model(const std::string& word) {
    if (word != "reduced_polynomial") {
      return tests::with(free_points(dimension), "neo_hookean", word);
    }
    return tests::with(tests::with(free_points(dimension), "model = \"neo_hookean\"",
                                   "model = \"reduced_polynomial\"\ncoefficients = [20, 5]\n"
                                   "compressibility = 0.02"),
                       "youngs_modulus = 100\npoissons_ratio = 0.3\n", "");
  }

  PointSolver<dimension> solver(const std::string& word,
                                const std::vector<std::string>& more = {}) const {
    return PointSolver<dimension>(tests::read_text(model(word), more),
                                  {1, kernels::widest_supported()});
  }

  static auto forces(PointSolver<dimension>& solver) { return forces_on_nodes<dimension>(solver); }

  static std::vector<std::string> short_step() { return {"time.step=1e-9"}; }
};

using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(PointForces, Dimensions);

TYPED_TEST(PointForces, are_the_slope_of_the_energy) {
  constexpr int D = TypeParam::value;
  for (const char* word : {"neo_hookean", "st_venant_kirchhoff", "reduced_polynomial"}) {
    auto solver = this->solver(word, this->short_step());
    auto& body = solver.state().bodies[0];
    deform(body, some_deformation<TypeParam::value>(), 0.01);
    const auto force = this->forces(solver);
    double largest = 0;
    for (const auto& f : force) largest = std::max(largest, std::abs(f[0]));
    for (const std::int64_t slot : {std::int64_t{0}, body.blocks[0].nodes / 2l}) {
      SCOPED_TRACE(word);
      expect_slope_of_energy<D>(solver, slot, force[slot], 1e-7 * largest);
    }
  }
}

TYPED_TEST(PointForces, of_a_turned_body_vanish) {
  constexpr int D = TypeParam::value;
  typename TestFixture::Matrix turn;
  if constexpr (D == 2) {
    turn = Eigen::Rotation2Dd(2).toRotationMatrix();
  } else {
    turn = Eigen::AngleAxisd(2, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  }
  auto solver = this->solver("neo_hookean", this->short_step());
  deform(solver.state().bodies[0], turn, 0);
  for (const auto& force : this->forces(solver)) {
    for (const double component : force) EXPECT_NEAR(component, 0, 1e-11);
  }
}

TYPED_TEST(PointForces, neither_push_nor_turn_a_free_body) {
  constexpr int D = TypeParam::value;
  auto solver = this->solver("neo_hookean", this->short_step());
  auto& body = solver.state().bodies[0];
  deform(body, some_deformation<TypeParam::value>(), 0.02);
  const auto force = this->forces(solver);
  expect_no_push_and_no_turn<D>(body, force);
}

// On nodes inside and at the surface, and with the stabilisation.
TYPED_TEST(PointForces, see_affine_fields_exactly) {
  constexpr int D = TypeParam::value;
  auto solver = this->solver("neo_hookean");
  auto& body = solver.state().bodies[0];
  const auto f = some_deformation<TypeParam::value>();
  deform(body, f, 0);
  double energy = 0;
  for (const NodeBlock& block : body.blocks) {
    for (int i = 0; i < block.nodes; ++i) {
      const auto node = point_based::node_state(body, block, block.first + i);
      for (int r = 0; r < D; ++r) {
        for (int c = 0; c < D; ++c) EXPECT_NEAR(node.gradient[D * r + c], f(r, c), 1e-13);
      }
      energy += node.energy;
    }
  }
  // (PB.6) written independently.
  Eigen::Matrix3d full = Eigen::Matrix3d::Identity();
  full.topLeftCorner<D, D>() = f;
  const double j = full.determinant(), mu = 100 / 2.6, lambda = 100 * 0.3 / (1.3 * 0.4);
  const double expected = mu / 2 * ((full.transpose() * full).trace() - 3) - mu * std::log(j) +
                          lambda / 2 * (j - 1) * (j - 1);
  EXPECT_NEAR(energy, expected, 1e-11 * expected);
}

// A mode that the gradient does not see inside a lattice.
TYPED_TEST(PointForces, resist_a_checkerboard_as_far_as_the_stabilisation_says) {
  constexpr int D = TypeParam::value;
  const auto energy = [&](const std::string& stabilisation) {
    auto solver = this->solver("neo_hookean", {"point_based.stabilisation=" + stabilisation});
    auto& body = solver.state().bodies[0];
    body.for_each_node([&](std::int64_t slot) {
      double sum = 0;
      for (int a = 0; a < D; ++a) sum += body.start[slot][a] / 0.125;
      body.displacement[0][slot] = std::lround(sum) % 2 == 0 ? 1e-4 : -1e-4;
    });
    return solver.integrals().strain_energy;
  };
  const double none = energy("0"), automatic = energy("automatic"), half = energy("0.05");
  // Nodes at the surface see the mode even without it.
  EXPECT_GT(automatic, 1.1 * none);
  EXPECT_NEAR(automatic - none, 2 * (half - none), 1e-9 * automatic);
}

// In 2D u = (x y, -(x^2 + y^2)/2) does not change volumes to first order: the energy of this
// bending depends only on the shear modulus, except for small errors of gradients at the surface.
TEST(point_stabilisation, does_not_resist_bending_more_where_volumes_are_kept) {
  const auto energy = [](double ratio) {
    PointSolver<2> solver(
        tests::read_text(free_points(2),
                         {"discretisation.spacing=0.05",
                          "material.rubber.poissons_ratio=" + std::to_string(ratio),
                          "material.rubber.youngs_modulus=" + std::to_string(100 * (1 + ratio))}),
        {1, kernels::widest_supported()});
    auto& body = solver.state().bodies[0];
    body.for_each_node([&](std::int64_t slot) {
      const double x = body.start[slot][0] - 0.5, y = body.start[slot][1] - 0.5;
      body.displacement[0][slot] = 1e-4 * x * y;
      body.displacement[1][slot] = -1e-4 * (x * x + y * y) / 2;
    });
    return solver.integrals().strain_energy;
  };
  // It would be 1.026 if the stabilisation used the modulus of pressure waves.
  EXPECT_LT(energy(0.49), 1.01 * energy(0.3));
}

// In a homogeneous stretch the stress on the face x = 1 of a block adds up to P N.
TYPED_TEST(PointForces, hold_an_affine_deformation_with_forces_near_the_surface_alone) {
  constexpr int D = TypeParam::value;
  auto solver = this->solver("neo_hookean", {"time.step=1e-9", "discretisation.spacing=0.0625"});
  auto& body = solver.state().bodies[0];
  deform(body, some_deformation<TypeParam::value>(), 0);
  const auto force = this->forces(solver);
  double largest = 0;
  for (std::int64_t s = 0; s < body.slots; ++s) {
    bool inside = true;
    for (int a = 0; a < D; ++a) {
      inside = inside && body.start[s][a] > 0.3 && body.start[s][a] < 0.7;
    }
    for (const double component : force[s]) {
      if (inside) {
        EXPECT_NEAR(component, 0, 1e-11);
      }
      largest = std::max(largest, std::abs(component));
    }
  }
  EXPECT_GT(largest, 0.01);
}

// The tenth and the eleventh neighbour of a node of a square lattice are equally far away, (PB.2).
// A deformation that is symmetric about y = x must cause forces with the same symmetry.
TEST(point_neighbours, that_are_equally_far_away_count_alike) {
  const Case settings =
      tests::read_text(free_points(2), {"point_based.neighbours=10", "time.step=1e-9"});
  PointSolver<2> solver(settings, {1, kernels::widest_supported()});
  auto& body = solver.state().bodies[0];
  const auto moved = [](double x, double y) { return 0.1 * std::sin(3 * x + 1) * std::cos(2 * y); };
  body.for_each_node([&](std::int64_t slot) {
    const auto& x = body.start[slot];
    body.displacement[0][slot] = moved(x[0], x[1]);
    body.displacement[1][slot] = moved(x[1], x[0]);
  });
  const auto force = PointForces<std::integral_constant<int, 2>>::forces(solver);
  body.for_each_node([&](std::int64_t slot) {
    body.for_each_node([&](std::int64_t other) {
      const auto &x = body.start[slot], &y = body.start[other];
      if (std::hypot(x[0] - y[1], x[1] - y[0]) > 1e-9) return;
      EXPECT_NEAR(force[slot][0], force[other][1], 1e-6) << x[0] << " " << x[1];
    });
  });
}

}  // namespace
}  // namespace pliant::test

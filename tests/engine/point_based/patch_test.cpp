#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <pliant/error.hpp>

#include "tests/engine/finite_elements/meshed_block.hpp"
#include "tests/engine/point_based/blocks.hpp"

// The patch test of the point-based method: in a uniform stress P the force on a node is -P a, with
// the node's share a of the undeformed surface.
namespace pliant::test {
namespace {

using Matrix3 = Eigen::Matrix3d;
using Vector3 = Eigen::Vector3d;

struct Patch : testing::Test {
  TemporaryFolder folder;

  PointSolver<3> solver(const std::string& gradient, int threads = 1) const {
    write(unit_block<3>(5), folder / "block.vtk");
    const std::string text =
        tests::with(meshed_block(folder / "block.vtk"), "finite_elements", "point_based");
    return PointSolver<3>(
        tests::read_text(text, {"time.step=1e-9", "point_based.gradient=" + gradient}),
        {threads, kernels::widest_supported()});
  }

  static std::vector<double> weights_of(PointSolver<3> solver) {
    std::vector<double> weights;
    const auto& body = solver.state().bodies[0];
    body.for_each_node([&](std::int64_t slot) {
      body.for_each_bond(
          body.block_of(slot), slot,
          [&](int, std::int64_t, const Point<3>&, double w) { weights.push_back(w); });
    });
    return weights;
  }

  /// The largest spurious force over |P| V^(2/3).
  static double error(PointSolver<3>& solver) {
    Matrix3 f;
    f << 1.2, 0.3, -0.1, -0.2, 0.9, 0.15, 0.05, -0.25, 1.1;
    const double j = f.determinant(), mu = 100 / 2.6, lambda = 100 * 0.3 / (1.3 * 0.4);
    const Matrix3 piola =
        mu * f + (lambda * (j - 1) - mu / j) * j * f.inverse().transpose();  // (PB.6)
    auto& body = solver.state().bodies[0];
    std::vector<Vector3> expected(body.slots, Vector3::Zero());
    for (const auto& facet : body.surface.facet) {
      std::array<Point<3>, 3> corner;
      for (int v = 0; v < 3; ++v) corner[v] = body.surface.start[facet[v]];
      const Point<3> area = undeformed::area_vector<3>(corner);
      for (const std::int32_t c : facet) {
        expected[body.surface.node[c]] -= piola * Vector3(area[0], area[1], area[2]) / 3;
      }
    }
    body.for_each_node([&](std::int64_t slot) {
      for (int i = 0; i < 3; ++i) {
        double d = -body.start[slot][i];
        for (int k = 0; k < 3; ++k) d += f(i, k) * body.start[slot][k];
        body.displacement[i][slot] = d;
      }
    });
    const double dt = solver.time_step();
    solver.step(dt);
    double worst = 0;
    body.for_each_node([&](std::int64_t slot) {
      Vector3 force;
      for (int a = 0; a < 3; ++a) force[a] = body.velocity[a][slot] * body.mass[slot] / dt;
      const double size = piola.norm() * std::pow(body.mass[slot], 2. / 3);
      worst = std::max(worst, (force - expected[slot]).norm() / size);
    });
    return worst;
  }
};

TEST_F(Patch, weights_that_pass_it_leave_no_force_inside_and_that_of_the_stress_outside) {
  auto exact = solver("patch_exact");
  EXPECT_LT(error(exact), 1e-5);
  // No compromise is needed: strains are exact, and weights positive.
  const auto& body = exact.state().bodies[0];
  for (const auto& block : body.blocks) {
    body.for_each_bond(block, block.first,
                       [&](int, std::int64_t, const Point<3>&, double w) { EXPECT_GT(w, 0); });
  }
}

// Without balancing weights, a force of .7 times the stress remains on a node of this block.
TEST_F(Patch, weights_that_balance_it_leave_a_few_hundredths_of_the_force) {
  auto balanced = solver("moving_least_squares");
  EXPECT_LT(error(balanced), 0.05);
}

TEST_F(Patch, weights_do_not_depend_on_the_number_of_threads) {
  for (const std::string gradient : {"patch_exact", "moving_least_squares"}) {
    EXPECT_EQ(weights_of(solver(gradient, 3)), weights_of(solver(gradient))) << gradient;
  }
}

TEST_F(Patch, a_body_whose_nodes_are_not_on_its_surface_is_refused) {
  const std::string ball =
      tests::with(free_points(3), "{ shape = \"box\", lower = [0, 0, 0], upper = [1, 1, 1] }",
                  "{ shape = \"ball\", centre = [0, 0, 0], radius = 0.5 }");
  const Case settings = tests::read_text(ball, {"point_based.gradient=patch_exact"});
  try {
    const PointSolver<3> solver(settings, {1, kernels::widest_supported()});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              "the nodes of body `block` do not lie on its surface, which point_based.gradient = "
              "\"patch_exact\" needs; take a mesh of tetrahedra, or a box of whole cells on a "
              "lattice");
  }
}

// Nodes that the cut does not reach stay exact: forces inside use the weights next to them.
TEST_F(Patch, bonds_that_no_cut_has_changed_keep_the_weights_that_pass_it) {
  write(unit_block<3>(7), folder / "block.vtk");
  const std::string cut =
      "[[cut]]\nname = \"blade\"\nfrom = [-0.1, -0.1, 0.15]\nto = [-0.1, 1.1, 0.15]\npath = "
      "[\"6e8*t\", 0, 0]\nend = 2e-9\n";
  PointSolver<3> solver(
      tests::read_text(
          tests::with(meshed_block(folder / "block.vtk"), "finite_elements", "point_based") + cut,
          {"time.step=1e-9", "point_based.gradient=patch_exact"}),
      {1, kernels::widest_supported()});
  for (int step = 0; step < 4; ++step) solver.step(HUGE_VAL);
  auto& body = solver.state().bodies[0];
  Matrix3 f;
  f << 1.2, 0.3, -0.1, -0.2, 0.9, 0.15, 0.05, -0.25, 1.1;
  body.for_each_node([&](std::int64_t slot) {
    for (int i = 0; i < 3; ++i) {
      body.velocity[i][slot] = 0;
      body.displacement[i][slot] = -body.start[slot][i];
      for (int k = 0; k < 3; ++k) body.displacement[i][slot] += f(i, k) * body.start[slot][k];
    }
  });
  solver.step(HUGE_VAL);
  int far = 0;
  body.for_each_node([&](std::int64_t slot) {
    const auto& x = body.start[slot];
    const bool is_inside = x[0] > 0.05 && x[0] < 0.95 && x[1] > 0.05 && x[1] < 0.95 && x[2] < 0.95;
    if (!is_inside || x[2] < 0.75) return;
    ++far;
    for (int a = 0; a < 3; ++a) {
      const double force = body.velocity[a][slot] * body.mass[slot] / 1e-9;
      EXPECT_NEAR(force, 0, 1e-3 * 100 * std::pow(body.mass[slot], 2. / 3));
    }
  });
  EXPECT_GT(far, 30);
}

TEST_F(Patch, too_few_neighbours_are_refused_where_they_are_given) {
  EXPECT_NE(tests::complaint(free_points(3) + "[point_based]\nneighbours = 3\n")
                .find("3 neighbours are too few for a gradient in 3D; give 4 or more"),
            std::string::npos);
}

}  // namespace
}  // namespace pliant::test

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/total_lagrangian/stress_point.hpp"
#include "tests/engine/total_lagrangian/blocks.hpp"

// Prony series of the bulk and of the shear modulus.
namespace pliant::test {
namespace {

constexpr double modulus = 2 / 0.05, ratios[] = {0.3, 0.2}, times[] = {0.5, 2};

/// A block that a wall holds everywhere, so that it keeps a given shape.
std::string held_block(const std::string& moduli) {
  return tests::with(free_block(2), "compressibility = 0.05\n",
                     "compressibility = 0.05\nprony = { ratios = [0.3, 0.2], times = [0.5, 2], "
                     "moduli = \"" +
                         moduli + "\" }\n") +
         R"([[boundary]]
name = "grip"
kind = "fixed"
geometry = { shape = "box", lower = [-9, -9], upper = [9, 9] }
)";
}

double pressure(const total_lagrangian::Body<double, 2>& body) {
  double found = std::nan("");
  body.layout.for_each_slot(body.layout.blocks()[0], [&](std::int64_t p, const Cell<2>& at) {
    if (std::isnan(found) && body.fraction[p] > 0) {
      found = total_lagrangian::stress_point<double, 2>(body, p, at).pressure;
    }
  });
  return found;
}

// (RP.10) for a sudden compression, also at output times within steps.
TEST(viscosity, a_sudden_compression_relaxes_by_its_prony_series) {
  for (const std::string moduli : {"instantaneous", "long_term"}) {
    LagrangianSolver<2> solver(tests::read_text(held_block(moduli)),
                               {1, kernels::widest_supported()});
    auto& body = solver.state().bodies[0];
    const double j = 0.97 * 1.01;
    for_each_particle<2>(body, [&](std::int64_t p, const Point<2>& x) {
      body.displacement[0][p] = -0.03 * x[0];
      body.displacement[1][p] = 0.01 * x[1];
    });
    const double sudden = moduli == "instantaneous" ? modulus : modulus / (1 - 0.3 - 0.2);
    for (const double t : {0.0, 0.1, 0.333, 1.0, 3.0}) {
      if (t > 0) solver.advance(t);
      double share = 1;
      for (int i = 0; i < 2; ++i) share -= ratios[i] * (1 - std::exp(-t / times[i]));
      EXPECT_NEAR(pressure(body) / (-sudden * (j - 1) * share), 1, 1e-9) << t << " " << moduli;
    }
  }
}

// The energy of the springs of the series is lost when they have relaxed.
TEST(viscosity, a_relaxed_block_has_the_energy_of_its_long_term_modulus) {
  LagrangianSolver<2> solver(tests::read_text(held_block("instantaneous")),
                             {1, kernels::widest_supported()});
  auto& body = solver.state().bodies[0];
  for_each_particle<2>(
      body, [&](std::int64_t p, const Point<2>& x) { body.displacement[0][p] = -0.05 * x[0]; });
  const double start = solver.integrals().strain_energy;
  solver.advance(20);  // ten times the longest relaxation time
  const double relaxed = modulus / 2 * 0.05 * 0.05 * (0.3 + 0.2);
  EXPECT_NEAR(start - solver.integrals().strain_energy, relaxed, 1e-4 * relaxed);
}

// Each block evaluates the cells between blocks for itself, from the same memory.
TEST(viscosity, forces_of_cells_between_blocks_are_in_balance) {
  const std::string text = tests::with(
      tests::with(free_block(3), "spacing = 0.125", "spacing = 0.0625"), "compressibility = 0.05\n",
      "compressibility = 0.05\nprony = { ratios = [0.3, 0.2], times = [0.05, 2], "
      "moduli = \"instantaneous\" }\n");
  LagrangianSolver<3> solver(tests::read_text(text), {1, kernels::widest_supported()});
  auto& body = solver.state().bodies[0];
  ASSERT_GT(body.layout.blocks().size(), 1);
  for_each_particle<3>(body, [&](std::int64_t p, const Point<3>& x) {
    body.velocity[0][p] = std::sin(3 * x[2]);
    body.velocity[2][p] = x[2] * x[2] + x[1];
  });
  for (int step = 0; step < 10; ++step) solver.step(HUGE_VAL);
  Point<3> sum = {};
  double size = 0;
  for_each_particle<3>(body, [&](std::int64_t p, const Point<3>&) {
    for (int a = 0; a < 3; ++a) {
      sum[a] += body.internal[a][p];
      size += std::abs(body.internal[a][p]);
    }
  });
  for (const double component : sum) EXPECT_NEAR(component, 0, 1e-13 * size);
}

/// The block, held everywhere, of a material whose shear modulus relaxes.
std::string block_that_relaxes_in_shear(int dimension, const std::string& moduli) {
  const std::string middle =
      dimension == 2 ? "[-9, -9], upper = [9, 9]" : "[-9, -9, -9], upper = [9, 9, 9]";
  return tests::with(
             free_block(dimension), "compressibility = 0.05\n",
             "compressibility = 0.05\nprony_shear = { ratios = [0.3, 0.2], times = [0.5, 2], "
             "moduli = \"" +
                 moduli + "\" }\n") +
         "[[boundary]]\nname = \"grip\"\nkind = \"fixed\"\ngeometry = { shape = \"box\", lower = " +
         middle + " }\n";
}

/// Deforms a block suddenly and permanently by F.
template <int D>
void deform(LagrangianSolver<D>& solver, const Eigen::Matrix<double, D, D>& f) {
  auto& body = solver.state().bodies[0];
  for_each_particle<D>(body, [&](std::int64_t p, const Point<D>& x) {
    for (int i = 0; i < D; ++i) {
      body.displacement[i][p] = -x[i];
      for (int j = 0; j < D; ++j) body.displacement[i][p] += f(i, j) * x[j];
    }
  });
}

template <int D>
total_lagrangian::StressPoint<D> first_stress_point(const LagrangianSolver<D>& solver) {
  const auto& body = solver.state().bodies[0];
  std::optional<total_lagrangian::StressPoint<D>> found;
  body.layout.for_each_slot(body.layout.blocks()[0], [&](std::int64_t p, const Cell<D>& at) {
    if (!found && body.fraction[p] > 0) {
      found = total_lagrangian::stress_point<double, D>(body, p, at);
    }
  });
  return *found;
}

template <int D>
Eigen::Matrix<double, D, D> large_deformation() {
  Eigen::Matrix3d f;
  f << 1.3, 0.4, -0.1, -0.2, 0.8, 0.15, 0.05, -0.25, 1.1;
  return f.template topLeftCorner<D, D>();
}

// (TL.24) for a sudden deformation of any size: the deviatoric stress relaxes by the series, the
// pressure stays.
template <int D>
void check_relaxation(const std::string& moduli) {
  LagrangianSolver<D> solver(tests::read_text(block_that_relaxes_in_shear(D, moduli)),
                             {1, kernels::widest_supported()});
  const auto f = large_deformation<D>();
  deform<D>(solver, f);
  Eigen::Matrix3d full = Eigen::Matrix3d::Identity();
  full.topLeftCorner<D, D>() = f;
  const double j = full.determinant();
  const Eigen::Matrix3d b = std::pow(j, -2. / 3) * full * full.transpose();
  const double sudden = moduli == "instantaneous" ? 10 : 10 / (1 - 0.3 - 0.2);
  for (const double t : {0.0, 0.1, 0.333, 1.0, 3.0}) {
    if (t > 0) solver.advance(t);
    double share = 1, energy = 0.5;
    for (int i = 0; i < 2; ++i) {
      share -= ratios[i] * (1 - std::exp(-t / times[i]));
      energy += ratios[i] * std::exp(-t / times[i]);
    }
    const auto point = first_stress_point(solver);
    EXPECT_NEAR(point.pressure, -2 / 0.05 * (j - 1), 1e-9) << t << " " << moduli;
    for (int i = 0; i < D; ++i) {
      for (int k = i; k < D; ++k) {
        const double deviator =
            point.stress[kernels::symmetric_index<D>(i, k)] + (i == k ? point.pressure : 0);
        const double exact = 2 * sudden * share / j * (b(i, k) - (i == k ? b.trace() / 3 : 0));
        EXPECT_NEAR(deviator, exact, 1e-8 * sudden) << t << " " << i << k << " " << moduli;
      }
    }
    const double held = sudden * energy * (b.trace() - 3) + (j - 1) * (j - 1) / 0.05;
    EXPECT_NEAR(point.energy / point.volume, held, 1e-8 * held) << t;
  }
}

TEST(viscosity, the_deviatoric_stress_of_a_sudden_deformation_relaxes_by_its_prony_series) {
  for (const std::string moduli : {"instantaneous", "long_term"}) {
    check_relaxation<2>(moduli);
    check_relaxation<3>(moduli);
  }
}

// The stress of a block that has relaxed under shear turns with the block.
TEST(viscosity, relaxed_networks_turn_with_the_body) {
  LagrangianSolver<3> solver(tests::read_text(block_that_relaxes_in_shear(3, "instantaneous")),
                             {1, kernels::widest_supported()});
  const Eigen::Matrix3d f = large_deformation<3>();
  deform<3>(solver, f);
  solver.advance(0.7);
  const auto before = first_stress_point(solver);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(2, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  deform<3>(solver, turn * f);
  const auto after = first_stress_point(solver);
  Eigen::Matrix3d sigma;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) sigma(i, k) = before.stress[kernels::symmetric_index<3>(i, k)];
  }
  const Eigen::Matrix3d turned = turn * sigma * turn.transpose();
  for (int i = 0; i < 3; ++i) {
    for (int k = i; k < 3; ++k) {
      EXPECT_NEAR(after.stress[kernels::symmetric_index<3>(i, k)], turned(i, k), 1e-10);
    }
  }
  EXPECT_NEAR(after.energy, before.energy, 1e-12);
}

/// A traction on the part of the surface in a box.
std::string traction_on(const std::string& name, const std::string& box, const std::string& force) {
  return "[[boundary]]\nname = \"" + name +
         "\"\nkind = \"traction\"\ngeometry = { shape = \"box\", " + box +
         " }\ntraction = " + force + "\n";
}

// Creep of the standard linear solid: under a constant shear stress s, the shear goes from s/mu to
// s/(mu (1 - g)) with the time constant tau/(1 - g).
TEST(viscosity, a_block_under_constant_shear_creeps_as_the_standard_linear_solid) {
  const std::string text =
      tests::with(free_block(2), "compressibility = 0.05\n",
                  "compressibility = 0.05\nprony_shear = { ratios = [0.6], times = [2], moduli = "
                  "\"instantaneous\" }\n") +
      traction_on("above", "lower = [-9, 0.999], upper = [9, 9]", "[0.02, 0]") +
      traction_on("below", "lower = [-9, -9], upper = [9, 0.001]", "[-0.02, 0]") +
      traction_on("right", "lower = [0.999, -9], upper = [9, 9]", "[0, 0.02]") +
      traction_on("left", "lower = [-9, -9], upper = [0.001, 9]", "[0, -0.02]");
  LagrangianSolver<2> solver(tests::read_text(text, {"time.end=8", "total_lagrangian.damping=10"}),
                             {1, kernels::widest_supported()});
  for (const double t : {2.0, 4.0, 8.0}) {
    solver.advance(t);
    const auto point = first_stress_point(solver);
    const double shear = point.deformation_gradient[0][1] + point.deformation_gradient[1][0];
    const double sudden = 0.02 / 20, relaxed = sudden / 0.4;
    // Damping delays the creep by alpha/omega^2, about 0.05 s of 5 s.
    EXPECT_NEAR(shear, relaxed - (relaxed - sudden) * std::exp(-t * 0.4 / 2), 0.01 * relaxed) << t;
  }
}

// The losses of the springs are the damping of a viscous block: a closed strain cycle consumes
// energy and never supplies it.
TEST(viscosity, cycles_of_shear_lose_the_energy_of_the_prony_series) {
  LagrangianSolver<2> solver(tests::read_text(block_that_relaxes_in_shear(2, "instantaneous")),
                             {1, kernels::widest_supported()});
  const Eigen::Matrix2d f = large_deformation<2>();
  double last = std::numeric_limits<double>::infinity();
  deform<2>(solver, f);
  for (int k = 1; k <= 20; ++k) {
    const double energy = solver.integrals().strain_energy;
    EXPECT_LE(energy, last);
    last = energy;
    solver.advance(0.2 * k);
  }
}

}  // namespace
}  // namespace pliant::test

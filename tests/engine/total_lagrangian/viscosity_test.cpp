#include <gtest/gtest.h>

#include <cmath>

#include "engine/total_lagrangian/stress_point.hpp"
#include "tests/engine/total_lagrangian/blocks.hpp"

// Prony series of the bulk modulus.
namespace pliant::test {
namespace {

constexpr double modulus = 2 / 0.05, ratios[] = {0.3, 0.2}, times[] = {0.5, 2};

/// A block that a wall holds everywhere, so that it keeps the shape that it is given.
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

// (RP.10) for a sudden compression, at output times inside steps too.
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

// What the springs of the series held is lost when they have relaxed.
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

// Blocks evaluate the cells between them each for itself, from the same memory.
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

}  // namespace
}  // namespace pliant::test

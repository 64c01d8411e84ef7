#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/remeshed/contact/contact_momentum_correction.hpp"
#include "engine/remeshed/solver.hpp"
#include "engine/simulation/run.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/output/file_content.hpp"
#include "tests/engine/output/temporary_folder.hpp"
#include "tests/engine/remeshed/small_case.hpp"

// A small body in 3D that uses the whole method.
namespace pliant::test {
namespace {

// Two materials, a curved and a plane surface.
TEST(three_dimensions, a_ball_gives_a_block_what_it_loses) {
  const Case settings = small_case("ball_on_block", {"discretisation.spacing=0.1", "measurement=[]",
                                                     "body.ball.velocity=[0.1, -0.5, 0]"});
  remeshed::Solver<double, 3> solver(settings, {2, kernels::widest_supported()});
  const Vector start = solver.integrals().momentum;
  advance_until(solver, 0.2);
  const Vector end = solver.integrals().momentum;
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(end[a], start[a], 1e-12 * std::abs(start[1]));
  EXPECT_LT((remeshed::budget_momentum<double, 3>(solver.state(), 1)[1]), 0.2 * start[1]);
}

constexpr const char* ball = R"(
title = "a spinning ball"
dimension = 3
discretisation = { spacing = 0.2, kernel = "compact" }
time = { end = 0.1, step = "cfl" }
remeshing = { every = 5 }
output = { every = 0.05, measure_every = 0.02 }
[[body]]
name = "ball"
geometry = { shape = "ball", centre = [0, 0, 0], radius = 1 }
material = { model = "linear", youngs_modulus = 100, poissons_ratio = 0.3, density = 1 }
rotation = { centre = [0, 0, 0], angular_velocity = [2, 4, 6] }
[[boundary]]
name = "floor"
kind = "fixed"
geometry = { shape = "half_space", point = [0, 0, -3], normal = [0, 0, 1] }
)";

FileContent result_of(const Case& settings, const std::filesystem::path& folder, int threads) {
  RunOptions options;
  options.folder = folder;
  options.quiet = true;
  options.isa = kernels::widest_supported();
  options.threads = threads;
  EXPECT_EQ(run_case(settings, options), RunEnd::done);
  return content_of(folder / "result.h5");
}

TEST(three_dimensions, bytes_do_not_depend_on_the_number_of_threads) {
  const TemporaryFolder folder;
  const Case settings = tests::read_text(ball);
  const FileContent one = result_of(settings, folder / "1", 1);
  for (const int threads : {2, 7}) {
    EXPECT_EQ(result_of(settings, folder / std::to_string(threads), threads), one) << threads;
  }
}

TEST(three_dimensions, a_spinning_ball_keeps_its_momentum_mass_and_energy) {
  const Case settings = tests::read_text(ball, {"discretisation.spacing=0.15"});
  remeshed::Solver<double, 3> solver(settings, {2, kernels::widest_supported()});
  const BodyIntegrals start = solver.integrals();
  EXPECT_NEAR(start.mass, 4. / 3 * std::numbers::pi, 0.01);
  advance_until(solver, 0.1);
  EXPECT_GE(solver.clock().remeshings, 2);
  const BodyIntegrals end = solver.integrals();
  EXPECT_NEAR(end.mass / start.mass, 1, 0.01);
  EXPECT_NEAR((end.kinetic_energy + end.strain_energy) / start.kinetic_energy, 1, 0.02);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(end.angular_momentum[axis] / start.angular_momentum[axis], 1, 0.01) << axis;
  }
}

TEST(three_dimensions, lists_of_neighbours_give_the_bits_of_the_stencil) {
  const Case settings = tests::read_text(ball);
  remeshed::Solver<double, 3> stencil(settings, {1, kernels::widest_supported()});
  remeshed::Solver<double, 3> lists(settings, {2, kernels::widest_supported()});
  remeshed::Body<double, 3>& body = lists.state().bodies[0];
  for (int step = 0; step < 4; ++step) {
    body.neighbours.strain = 1;  // beyond the range of any stencil
    body.neighbours.strain_rate = 0.05 / lists.time_step();
    for (auto* solver : {&stencil, &lists}) solver->step(HUGE_VAL);
    const auto& blocks = body.neighbours.blocks;
    ASSERT_TRUE(blocks[blocks.size() / 2].are_listed);
  }
  for (int a = 0; a < 3; ++a) {
    const double* expected = stencil.state().bodies[0].stage[0].get(Field::velocity, a);
    const double* found = body.stage[0].get(Field::velocity, a);
    const auto slots = body.population.layout.slots();
    EXPECT_TRUE(std::equal(expected, expected + slots, found)) << a;
  }
}

// Compressed along the diagonal (2, 2, 1), whose node is as far away as (3, 0, 0) and not in the
// stencil: when 20 % shorter, only this one enters the support.
TEST(three_dimensions, corners_that_the_stencil_leaves_out_are_listed) {
  const Case settings = tests::read_text(ball, {"discretisation.kernel=\"quartic_spline\""});
  remeshed::Solver<double, 3> solver(settings, {1, kernels::widest_supported()});
  remeshed::Body<double, 3>& body = solver.state().bodies[0];
  const Layout<3>& layout = body.population.layout;
  constexpr Point<3> direction = {2. / 3, 2. / 3, 1. / 3};
  for (const Block<3>& block : layout.blocks()) {
    layout.for_each_slot(block, [&](std::int64_t p, const Cell<3>& cell) {
      if (body.population.kind[p] == Kind::vacant) return;
      const Point<3> x = body.lattice.node(cell);
      const double along = x[0] * direction[0] + x[1] * direction[1] + x[2] * direction[2];
      for (int a = 0; a < 3; ++a) {
        body.stage[0].get(Field::drift, a)[p] = -0.2 * along * direction[a];
      }
    });
  }
  body.neighbours.strain = 1;  // beyond the range of any stencil
  solver.step(1e-6);
  const std::int64_t p = layout.slot({0, 0, 0});
  ASSERT_EQ(body.population.kind[p], Kind::interior);
  constexpr int pack = Layout<3>::pack;
  for (std::size_t b = 0; b < layout.blocks().size(); ++b) {
    const Block<3>& block = layout.blocks()[b];
    if (p < block.first_slot || p >= block.first_slot + block.slot_count) continue;
    ASSERT_TRUE(body.neighbours.blocks[b].are_listed);
    const auto lists = body.neighbours.lists(static_cast<int>(b));
    bool found = false;
    for (int k = 0; k < lists.length[p / pack]; ++k) {
      const std::int64_t entry = lists.start[p / pack] + k * pack + p % pack;
      found = found || (lists.offset[0][entry] == 2 && lists.offset[1][entry] == 2 &&
                        lists.offset[2][entry] == 1);
    }
    EXPECT_TRUE(found);
  }
}

}  // namespace
}  // namespace pliant::test

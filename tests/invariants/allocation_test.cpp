#include <gtest/gtest.h>

#include "engine/point_based/solver.hpp"
#include "tests/allocation_counter.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/invariants/sample_runs.hpp"

namespace pliant::test {
namespace {

struct Allocation : OfSampleRuns {};
INSTANTIATE_TEST_SUITE_P(runs, Allocation, testing::ValuesIn(sample_runs()), name_of);

TEST_P(Allocation, a_warm_step_allocates_nothing) {
  for (const int threads : {1, 2, 7}) {
    Case settings = GetParam().settled();
    settings.remeshing.policy = decltype(settings.remeshing)::Policy::never;
    Solver solver(settings, {threads, kernels::widest_supported()});
    EXPECT_EQ(least_allocations([&] { advance(solver, 8); }), 0) << threads << " threads";
  }
}

TEST_P(Allocation, a_warm_remeshing_of_an_unchanged_set_allocates_nothing) {
  for (const int threads : {1, 2, 7}) {
    Case settings = GetParam().settled();
    settings.remeshing.policy = decltype(settings.remeshing)::Policy::every;
    settings.remeshing.every = 2;
    // At rest nothing moves: the set of particles is the same after each remeshing.
    for (BodyCase& body : settings.bodies) body.velocity = {};
    for (BoundaryCase& wall : settings.boundaries) wall.velocity = VectorExpression{};
    Solver solver(settings, {threads, kernels::widest_supported()});
    EXPECT_EQ(least_allocations([&] { advance(solver, 8); }), 0) << threads << " threads";
    EXPECT_GE(solver.clock().remeshings, 8);
  }
}

// Lists grow as a body is compressed, until they reach their final size.
TEST(allocation, a_warm_search_for_neighbours_allocates_nothing) {
  for (const SampleRun& run : listed_runs()) {
    for (const int threads : {1, 2, 7}) {
      Solver solver(run.settled(), {threads, kernels::widest_supported()});
      advance(solver, run.middle);
      remeshed::BodyNeighbours<2>& neighbours = solver.state().bodies[0].neighbours;
      ASSERT_TRUE(neighbours.are_listed);
      const auto step_with_search = [&] {
        neighbours.complete_until = 0;
        advance(solver, 1);
        EXPECT_GT(neighbours.complete_until, 0);
      };
      EXPECT_EQ(least_allocations(step_with_search), 0) << run << ", " << threads << " threads";
    }
  }
}

// When the blade moves, the lists of its cut grow, and space is allocated for new bonds of nodes.
// In the steps between, kept gradients of nodes relax.
TEST(allocation, a_step_allocates_nothing_between_two_moves_of_a_blade) {
  const Case settings = tests::read_text(R"toml(dimension = 3
method = "point_based"
[discretisation]
spacing = 0.1
[time]
end = 10
step = 1e-3
[[body]]
name = "block"
geometry = { shape = "box", lower = [0, 0, 0], upper = [1, 1, 1] }
material = { model = "neo_hookean", youngs_modulus = 100, poissons_ratio = 0.3, density = 2 }
velocity = ["sin(3*y)", 0, "x"]
[[cut]]
name = "blade"
from = [0.55, -0.1, 0.4]
to = [0.55, -0.1, 1.1]
path = [0, "min(20*t, 0.7)", 0]
end = 10
)toml");
  for (const int threads : {1, 2}) {
    point_based::Solver<double, 3> solver(settings, {threads, kernels::widest_supported()});
    const int before = allocations();
    for (int step = 0; step < 40; ++step) solver.step(HUGE_VAL);
    EXPECT_GT(allocations() - before, 40);
    const double work = solver.energy_budget()->cut_work;
    EXPECT_EQ(least_allocations([&] {
                for (int step = 0; step < 4; ++step) solver.step(HUGE_VAL);
              }),
              0)
        << threads << " threads";
    EXPECT_LT(solver.energy_budget()->cut_work, work);
  }
}

TEST(allocation, is_counted) {
  const int before = allocations();
  ::operator delete(::operator new(4));
  Buffer<double> buffer;
  buffer.grow(10, 0);
  EXPECT_EQ(allocations() - before, 2);
}

}  // namespace
}  // namespace pliant::test

#include <gtest/gtest.h>

#include "tests/allocation_counter.hpp"
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

// Lists grow as a body is compressed, until they have found their size.
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

TEST(allocation, is_counted) {
  const int before = allocations();
  ::operator delete(::operator new(4));
  Buffer<double> buffer;
  buffer.grow(10, 0);
  EXPECT_EQ(allocations() - before, 2);
}

}  // namespace
}  // namespace pliant::test

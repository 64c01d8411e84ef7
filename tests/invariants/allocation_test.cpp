#include <gtest/gtest.h>

#include "tests/invariants/allocation_counter.hpp"
#include "tests/invariants/sample_runs.hpp"

namespace pliant::test {
namespace {

struct allocation : OfSampleRuns {};
INSTANTIATE_TEST_SUITE_P(runs, allocation, testing::ValuesIn(sample_runs()), name_of);

TEST_P(allocation, a_warm_step_allocates_nothing) {
  for (const int threads : {1, 2, 7}) {
    Case settings = GetParam().settled();
    settings.remeshing.policy = decltype(settings.remeshing)::Policy::never;
    Solver solver(settings, threads, kernels::widest_supported());
    advance(solver, 2);
    const int before = allocations();
    advance(solver, 20);
    EXPECT_EQ(allocations() - before, 0) << threads << " threads";
  }
}

TEST_P(allocation, a_warm_remeshing_of_an_unchanged_set_allocates_nothing) {
  for (const int threads : {1, 2, 7}) {
    Case settings = GetParam().settled();
    settings.remeshing.policy = decltype(settings.remeshing)::Policy::every;
    settings.remeshing.every = 2;
    // At rest nothing moves: the set of particles is the same after each remeshing.
    settings.bodies[0].velocity = VectorExpression{};
    for (BoundaryCase& wall : settings.boundaries) wall.velocity = VectorExpression{};
    Solver solver(settings, threads, kernels::widest_supported());
    advance(solver, 40);
    const int before = allocations();
    advance(solver, 8);
    EXPECT_EQ(allocations() - before, 0) << threads << " threads";
  }
}

}  // namespace
}  // namespace pliant::test

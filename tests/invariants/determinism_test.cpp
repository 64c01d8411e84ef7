#include <gtest/gtest.h>

#include "engine/remeshed/solver.hpp"
#include "engine/remeshed/state/resources.hpp"
#include "tests/invariants/sample_runs.hpp"

// The bits of a result depend on the case alone.
namespace pliant::test {
namespace {

struct Determinism : OfSampleRuns {};
INSTANTIATE_TEST_SUITE_P(runs, Determinism, testing::ValuesIn(sample_runs()), name_of);
INSTANTIATE_TEST_SUITE_P(listed_runs, Determinism, testing::ValuesIn(listed_runs()), name_of);

/// The state after a run, with the measurements of the case.
Snapshot end_of(const SampleRun& run, int threads) {
  Solver solver(run.settled(), {threads, kernels::widest_supported()});
  advance(solver, run.steps);
  EXPECT_GE(solver.clock().remeshings, 3) << "the run is too short to tell";
  Snapshot end = snapshot_of(solver);
  end["measurements"] = solver.measure();
  return end;
}

TEST_P(Determinism, bits_do_not_depend_on_the_number_of_threads) {
  const Snapshot one = end_of(GetParam(), 1);
  EXPECT_GT(one.at("cell").size(), 2 * 600u);
  for (const int threads : {2, 7}) {
    EXPECT_EQ(differences(one, end_of(GetParam(), threads)), none) << threads << " threads";
  }
}

TEST_P(Determinism, measuring_changes_nothing_in_the_trajectory) {
  Solver solver(GetParam().settled(), {1, kernels::widest_supported()});
  Solver measured(GetParam().settled(), {1, kernels::widest_supported()});
  for (int i = 0; i < GetParam().steps; ++i) {
    advance(solver, 1);
    advance(measured, 1);
    measured.measure();
    if (i % 3 == 0) measured.refresh_ghosts();
  }
  // Ghosts hold whatever was last requested of them.
  EXPECT_EQ(
      differences(snapshot_of(solver, Slots::particles), snapshot_of(measured, Slots::particles)),
      none);
}

// Observes two times within each step.
TEST_P(Determinism, looking_ahead_changes_nothing_in_the_trajectory) {
  Solver solver(GetParam().settled(), {1, kernels::widest_supported()});
  Solver watched(GetParam().settled(), {1, kernels::widest_supported()});
  for (int i = 0; i < GetParam().steps; ++i) {
    const double now = watched.clock().time, length = watched.next_step(HUGE_VAL);
    for (const double part : {0.3, 0.8}) {
      watched.look_ahead(now + part * length, [&] {
        EXPECT_NEAR(watched.clock().time, now + part * length, 1e-15);
        watched.measure();
        if (i % 3 == 0) watched.refresh_ghosts();
      });
    }
    advance(solver, 1);
    advance(watched, 1);
  }
  EXPECT_EQ(
      differences(snapshot_of(solver, Slots::particles), snapshot_of(watched, Slots::particles)),
      none);
}

TEST_P(Determinism, a_look_ahead_shows_what_a_step_until_then_leads_to) {
  Solver solver(GetParam().settled(), {1, kernels::widest_supported()});
  Solver other(GetParam().settled(), {1, kernels::widest_supported()});
  const double time = 0.4 * solver.next_step(HUGE_VAL);
  other.step(time);
  const std::vector<double> expected = other.measure();
  solver.look_ahead(time, [&] {
    const std::vector<double> found = solver.measure();
    for (std::size_t m = 0; m < expected.size(); ++m) {
      if (std::isnan(expected[m])) continue;
      EXPECT_EQ(found[m], expected[m]) << "measurement " << m;
    }
  });
  EXPECT_EQ(solver.clock().time, 0);
}

/// Runs a graph in the order of its list, or in another valid one.
void run(scheduler::StepGraph& graph, Solver& solver, std::uint64_t seed) {
  solver.workers().execute([&] { graph.run_serially(seed); });
}

TEST_P(Determinism, any_legal_order_of_a_step_gives_the_same_bits) {
  Solver solver(GetParam().settled(), {1, kernels::widest_supported()});
  advance(solver, GetParam().middle);
  Snapshot first;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    Solver other(GetParam().settled(), {1, kernels::widest_supported()});
    advance(other, GetParam().middle);
    run(other.step_graph(), other, seed);  // once more over the same time step
    const Snapshot end = snapshot_of(other);
    if (seed == 0) {
      ASSERT_NE(differences(snapshot_of(solver), end), none) << "nothing has moved";
      solver.step_graph().run(solver.workers());
      EXPECT_EQ(differences(snapshot_of(solver), end), none) << "against the parallel order";
      first = end;
    }
    EXPECT_EQ(differences(first, end), none) << "seed " << seed;
  }
}

/// The graph of the phases that `add` adds for a body, over the blocks of `layout`.
template <class F>
scheduler::StepGraph graph_over(const Layout<2>& layout, F&& add) {
  std::vector<scheduler::Phase> phases;
  add(phases);
  return {std::move(phases), scheduler::Blocks{layout.neighbours()}, remeshed::resource::names()};
}

TEST_P(Determinism, any_legal_order_of_a_remeshing_gives_the_same_bits) {
  Solver solver(GetParam().settled(), {1, kernels::widest_supported()});
  advance(solver, GetParam().middle);
  Body& body = solver.state().bodies[0];
  auto& remeshing = solver.remeshing(0);
  solver.on_nodes();
  Snapshot first;
  add_body(first, {body, body.spare, body.stage[1]}, Slots::all);
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    auto source = graph_over(body.population.layout,
                             [&](auto& phases) { remeshing.source_phases(phases, 0); });
    run(source, solver, seed);
    auto target = graph_over(body.spare.layout,
                             [&](auto& phases) { remeshing.target_phases(phases, 0, true); });
    run(target, solver, seed);
    Snapshot end;
    add_body(end, {body, body.spare, body.stage[1]}, Slots::all);
    EXPECT_EQ(differences(first, end), none) << "seed " << seed;
  }
}

}  // namespace
}  // namespace pliant::test

#include <benchmark/benchmark.h>

#include "engine/bench/cases.hpp"
#include "engine/remeshed/solver.hpp"

// A step between remeshings over the stencil and over neighbour lists, and the search that makes
// the lists.
//
// For the lists, the cylinder is compressed by a fifth in both directions relative to its lattice.
// Its particles then have 33 neighbours within the support of the quartic kernel and its skin,
// compared to 24 slots of the stencil (16 and 8 with the compact kernel). Items are interior
// particle-stages, or the particles of a search.
namespace pliant::bench {
namespace {

using kernels::Kernel;
using Solver = remeshed::Solver<double, 2>;

constexpr double size = 0.8;

Case without_remeshing(std::int64_t particles, Kernel kernel) {
  Case settings = rotating_cylinder(particles, kernel);
  settings.remeshing.policy = decltype(settings.remeshing)::Policy::never;
  settings.time.end = 1;
  settings.time.step = 1e-9;  // no motion during the measurement
  return settings;
}

void compress(Solver& solver) {
  remeshed::Body<double, 2>& body = solver.state().bodies[0];
  const auto& population = body.population;
  for (const Block<2>& block : population.layout.blocks()) {
    population.layout.for_each_slot(block, [&](std::int64_t p, const Cell<2>& cell) {
      if (population.kind[p] == kernels::Kind::vacant) return;
      for (int a = 0; a < 2; ++a) {
        body.stage[0].get(remeshed::Field::drift, a)[p] =
            (size - 1) * body.lattice.node(a, cell[a]);
      }
    });
  }
  body.neighbours.strain = 1;  // more than any stencil allows
}

void step(benchmark::State& state, Kernel kernel, bool over_lists) {
  Solver solver(without_remeshing(state.range(0), kernel),
                {static_cast<int>(state.range(1)), kernels::widest_supported()});
  if (over_lists) compress(solver);
  solver.step(1);
  for (auto _ : state) solver.step(1);
  if (solver.state().bodies[0].neighbours.are_listed != over_lists) {
    state.SkipWithError("the neighbours are not those that were to be timed");
  }
  state.SetItemsProcessed(4 * solver.particles() * static_cast<std::int64_t>(state.iterations()));
}

void search(benchmark::State& state, Kernel kernel) {
  Solver solver(without_remeshing(state.range(0), kernel),
                {static_cast<int>(state.range(1)), kernels::widest_supported()});
  compress(solver);
  solver.step(1);
  const auto seconds = [&] {
    double sum = 0;
    for (const auto& timer : solver.step_totals().timers()) {
      if (timer.name == "cells" || timer.name == "neighbours") sum += timer.seconds;
    }
    return sum;
  };
  for (auto _ : state) {
    solver.state().bodies[0].neighbours.complete_until = 0;
    const double before = seconds();
    solver.step(1);
    state.SetIterationTime((seconds() - before) / static_cast<double>(state.range(1)));
  }
  state.SetItemsProcessed(solver.particles() * static_cast<std::int64_t>(state.iterations()));
}

void sizes_and_threads(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"particles", "threads"})
      ->ArgsProduct({{10'000, 100'000}, {1, 2}})
      ->Unit(benchmark::kMillisecond);
}
void over_stencil(benchmark::State& state, Kernel kernel) { step(state, kernel, false); }
void over_lists(benchmark::State& state, Kernel kernel) { step(state, kernel, true); }

BENCHMARK_CAPTURE(over_stencil, quartic_spline_fit, Kernel::quartic_spline_fit)
    ->Apply(sizes_and_threads)
    ->UseRealTime();
BENCHMARK_CAPTURE(over_lists, quartic_spline_fit, Kernel::quartic_spline_fit)
    ->Apply(sizes_and_threads)
    ->UseRealTime();
BENCHMARK_CAPTURE(search, quartic_spline_fit, Kernel::quartic_spline_fit)
    ->Apply(sizes_and_threads)
    ->UseManualTime();
BENCHMARK_CAPTURE(over_stencil, compact, Kernel::compact)->Apply(sizes_and_threads)->UseRealTime();
BENCHMARK_CAPTURE(over_lists, compact, Kernel::compact)->Apply(sizes_and_threads)->UseRealTime();
BENCHMARK_CAPTURE(search, compact, Kernel::compact)->Apply(sizes_and_threads)->UseManualTime();

}  // namespace
}  // namespace pliant::bench

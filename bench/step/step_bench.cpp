#include <benchmark/benchmark.h>

#include <string>

#include "engine/bench/cases.hpp"
#include "engine/bench/stage_cost.hpp"
#include "engine/remeshed/solver.hpp"

// Ten steps and the following remeshing: the rotating cylinder with the whole solver.
//
// Items are interior particle-stages, with everything included. Shares are of the time of all
// threads; `idle` is the rest of it outside phases. `pliant bench` measures the same in turns,
// together with the machine's own rates, and is more reliable on a machine with other load.
namespace pliant::bench {
namespace {

using kernels::Kernel;
using Solver = remeshed::Solver<double, 2>;

constexpr int steps_per_remeshing = 10;

void advance(Solver& solver) {
  for (int step = 0; step < steps_per_remeshing; ++step) {
    solver.step(solver.settings().time.end - solver.clock().time);
  }
}

double seconds_of(const scheduler::StepTotals& totals, const std::string& phase) {
  for (const auto& timer : totals.timers()) {
    if (timer.name == phase) return timer.seconds;
  }
  return 0;
}

// Arguments: particles, threads.
void rotating_cylinder_steps(benchmark::State& state, Kernel kernel) {
  const auto threads = static_cast<int>(state.range(1));
  Solver solver(rotating_cylinder(state.range(0), kernel), {threads, kernels::widest_supported()});
  advance(solver);
  const scheduler::StepTotals before = solver.step_totals();
  const std::int64_t stages = solver.particle_stages();
  const double loop = solver.step_seconds();
  for (auto _ : state) advance(solver);

  state.SetItemsProcessed(solver.particle_stages() - stages);
  state.counters["particles"] = static_cast<double>(solver.particles());
  state.counters["bytes_per_particle"] =
      static_cast<double>(solver.bytes()) / static_cast<double>(solver.particles());
  const double available = threads * (solver.step_seconds() - loop);
  double idle = 1;
  for (const auto& timer : solver.step_totals().timers()) {
    const double share = (timer.seconds - seconds_of(before, timer.name)) / available;
    state.counters[timer.name] = share;
    idle -= share;
  }
  state.counters["idle"] = idle;
  const double stages_per_second =
      static_cast<double>(solver.particle_stages() - stages) / (solver.step_seconds() - loop);
  state.counters["GFLOP/s"] =
      1e-9 * stages_per_second * flop_per_stage(kernel, kernels::Model::linear);
  state.counters["GB/s"] = 1e-9 * stages_per_second * bytes_per_stage(kernels::Model::linear);
}

void sizes_and_threads(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"particles", "threads"})
      ->ArgsProduct({{1'000, 10'000, 100'000, 131'072, 1'000'000}, {1, 2}})
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}
BENCHMARK_CAPTURE(rotating_cylinder_steps, quartic, Kernel::quartic_spline)
    ->Apply(sizes_and_threads);
BENCHMARK_CAPTURE(rotating_cylinder_steps, quartic_spline_fit, Kernel::quartic_spline_fit)
    ->Apply(sizes_and_threads);
BENCHMARK_CAPTURE(rotating_cylinder_steps, compact, Kernel::compact)->Apply(sizes_and_threads);

}  // namespace
}  // namespace pliant::bench

#include "engine/bench/sample.hpp"

#include <ctime>
#include <numeric>

#include "engine/remeshed/solver.hpp"

namespace pliant::bench {

namespace {

double processor_time() {
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

template <class Solver>
void advance(Solver& solver, std::int64_t steps) {
  const double end = solver.settings().time.end;
  for (std::int64_t i = 0; i < steps && solver.clock().time < end * (1 - 1e-9); ++i) {
    solver.step(end - solver.clock().time);
  }
}

// Names are those of `after`, in its order.
std::vector<scheduler::StepTotals::Timer> difference(const scheduler::StepTotals& after,
                                                     const scheduler::StepTotals& before) {
  std::vector<scheduler::StepTotals::Timer> timers = after.timers();
  for (auto& timer : timers) {
    for (const auto& old : before.timers()) {
      if (old.name == timer.name) timer.seconds -= old.seconds;
    }
  }
  return timers;
}

void add_calibration(Sample& sample, int threads, kernels::Isa isa, Triad& triad) {
  sample.fma_peak += fma_peak(isa, threads) / 2;
  sample.triad += triad(threads) / 2;
}

template <int D>
Sample measure_in(const Case& settings, const Window& window, int threads, kernels::Isa isa,
                  Triad& triad) {
  remeshed::Solver<double, D> solver(settings, threads, isa);
  advance(solver, window.steps_before);
  Sample sample;
  add_calibration(sample, threads, isa, triad);
  const scheduler::StepTotals before = solver.totals();
  const remeshed::Clock clock = solver.clock();
  const std::int64_t stages = solver.particle_stages();
  const double loop = solver.loop_seconds(), processor = processor_time();
  advance(solver, window.steps);
  sample.processor_seconds = processor_time() - processor;
  sample.wall_seconds = solver.loop_seconds() - loop;
  add_calibration(sample, threads, isa, triad);
  sample.particle_stages = solver.particle_stages() - stages;
  sample.steps = solver.clock().step - clock.step;
  sample.remeshings = solver.clock().remeshings - clock.remeshings;
  sample.particles = solver.particles();
  sample.bytes_per_particle =
      static_cast<double>(solver.bytes()) / static_cast<double>(solver.particles());
  sample.phases = difference(solver.totals(), before);
  sample.phase_seconds =
      std::accumulate(sample.phases.begin(), sample.phases.end(), 0.0,
                      [](double sum, const auto& timer) { return sum + timer.seconds; });
  return sample;
}

}  // namespace

Sample measure(const Case& settings, const Window& window, int threads, kernels::Isa isa,
               Triad& triad) {
  return settings.dimension == 2 ? measure_in<2>(settings, window, threads, isa, triad)
                                 : measure_in<3>(settings, window, threads, isa, triad);
}

}  // namespace pliant::bench

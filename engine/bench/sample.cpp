#include "engine/bench/sample.hpp"

#include <malloc.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <memory>
#include <numeric>

#include "engine/simulation/methods.hpp"

namespace pliant::bench {

namespace {

using Clock = std::chrono::steady_clock;

double resident_bytes() {
  std::ifstream file("/proc/self/statm");
  double all_pages = 0, resident_pages = 0;
  file >> all_pages >> resident_pages;
  return resident_pages * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

// Names are in the order of `after`.
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
  sample.hand_over += hand_over(threads) / 2;
}

}  // namespace

Sample measure(const Case& settings, const Window& window, int threads, kernels::Isa isa,
               Triad& triad) {
  Sample sample;
  ::malloc_trim(0);  // frees what earlier samples have left
  const double resident = resident_bytes();
  const auto before_setup = Clock::now();
  const std::unique_ptr<Solver> made = methods().make(settings, {threads, isa});
  sample.setup_seconds = std::chrono::duration<double>(Clock::now() - before_setup).count();
  Solver& solver = *made;
  advance(solver, window.steps_before);
  add_calibration(sample, threads, isa, triad);
  const scheduler::StepTotals before = solver.step_totals();
  const std::int64_t steps = solver.clock().step, remeshings = solver.remeshings();
  const std::int64_t stages = solver.particle_stages();
  sample.elapsed = advance(solver, window.steps);
  add_calibration(sample, threads, isa, triad);
  sample.particle_stages = solver.particle_stages() - stages;
  sample.steps = solver.clock().step - steps;
  sample.remeshings = solver.remeshings() - remeshings;
  sample.particles = solver.particles();
  sample.bytes_per_particle =
      static_cast<double>(solver.bytes()) / static_cast<double>(solver.particles());
  sample.resident_per_particle =
      (resident_bytes() - resident) / static_cast<double>(solver.particles());
  sample.phases = difference(solver.step_totals(), before);
  sample.phase_seconds =
      std::accumulate(sample.phases.begin(), sample.phases.end(), 0.0,
                      [](double sum, const auto& timer) { return sum + timer.seconds; });
  return sample;
}

}  // namespace pliant::bench

#include "engine/bench/steps.hpp"

#include <ctime>

#include "engine/bench/handicap.hpp"

namespace pliant::bench {

namespace {

double time_of(clockid_t clock) {
  timespec time;
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// The handicap is a share of the processor time of the step, so that interruptions by other
// programs do not count.
void step(Solver& solver) {
  const double longest = solver.settings().time.end - solver.clock().time;
  if (handicap() == 0) return solver.step(longest);
  const double start = time_of(CLOCK_THREAD_CPUTIME_ID);
  solver.step(longest);
  const double now = time_of(CLOCK_THREAD_CPUTIME_ID), until = now + handicap() * (now - start);
  while (time_of(CLOCK_THREAD_CPUTIME_ID) < until) continue;
}

}  // namespace

bool is_over(const Solver& solver) {
  return solver.clock().time >= solver.settings().time.end * (1 - 1e-9);
}

Elapsed advance(Solver& solver, std::int64_t steps) {
  const double wall = time_of(CLOCK_MONOTONIC), processor = time_of(CLOCK_PROCESS_CPUTIME_ID);
  for (std::int64_t i = 0; i < steps && !is_over(solver); ++i) step(solver);
  return {time_of(CLOCK_MONOTONIC) - wall, time_of(CLOCK_PROCESS_CPUTIME_ID) - processor};
}

}  // namespace pliant::bench

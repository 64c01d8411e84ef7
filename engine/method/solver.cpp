#include "engine/method/solver.hpp"

#include <chrono>

namespace pliant {

Solver::Solver(const Case& settings, const SolverOptions& options)
    : settings_(settings), workers_(options.threads) {}

void Solver::step(double longest) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  take_step(step_length(settings_, clock(), time_step(), longest));
  step_seconds_ += std::chrono::duration<double>(Clock::now() - start).count();
}

void Solver::advance(double until) {
  constexpr double rounding = 1e-12;
  while (clock().time < until * (1 - rounding)) step(until - clock().time);
}

void Solver::run(scheduler::StepGraph& graph) {
  graph.run(workers_);
  graph.record().simulated_time = clock().time;
  step_totals_.add(graph.record(), graph.timer_names());
}

}  // namespace pliant

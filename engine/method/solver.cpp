#include "engine/method/solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "engine/case/placement.hpp"
#include "engine/method/step_length.hpp"
#include "engine/output/error.hpp"

namespace pliant {

Solver::Solver(const Case& settings, const SolverOptions& options)
    : settings_(settings), workers_(options.threads) {
  load_meshes(settings_);
}

double Solver::next_step(double longest) const {
  return step_length(settings_, clock(), time_step(), longest);
}

void Solver::look_ahead(double, const std::function<void()>&) {
  throw std::logic_error("this method does not look ahead");
}

void Solver::step(double longest) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  take_step(next_step(longest));
  step_seconds_ += std::chrono::duration<double>(Clock::now() - start).count();
}

void Solver::advance(double until) {
  constexpr double rounding = 1e-12;
  while (clock().time < until * (1 - rounding)) step(until - clock().time);
}

std::optional<EnergyBudget> Solver::energy_budget() const {
  return bodies_are_free() ? std::optional(EnergyBudget{}) : std::nullopt;
}

bool Solver::bodies_are_free() const {
  return settings_.boundaries.empty() &&
         std::none_of(settings_.cuts.begin(), settings_.cuts.end(),
                      [](const CutCase& cut) { return cut.resists(); }) &&
         std::all_of(settings_.gravity.begin(), settings_.gravity.end(),
                     [](const Expression& g) { return g.is_constant() && g(0) == 0; });
}

void Solver::save(ArchiveWriter& archive) const {
  archive.put("method", settings_.method);
  save_state(archive);
}

void Solver::restore(const ArchiveReader& archive) {
  const std::string method = archive.text("method");
  if (method != settings_.method) {
    throw OutputError(
        archive.path(),
        fmt::format("is a state of method \"{}\", not of \"{}\"", method, settings_.method),
        "restore it with the case that it was saved with");
  }
  restore_state(archive);
}

void Solver::run(scheduler::StepGraph& graph) {
  graph.run(workers_);
  graph.record().simulated_time = clock().time;
  step_totals_.add(graph.record(), graph.timer_names());
  if (observe_graph_) observe_graph_(graph);
}

}  // namespace pliant

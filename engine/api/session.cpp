#include "engine/api/session.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "engine/api/find.hpp"

namespace pliant {

Blades& blades_of(Solver& solver) {
  if (auto* const blades = dynamic_cast<Blades*>(&solver)) return *blades;
  throw InputError(
      fmt::format("method \"{}\" does not cut; use point_based", solver.settings().method));
}

namespace {

constexpr double rounding = 1e-12;

double now() {
  using Clock = std::chrono::steady_clock;
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

bool is_finite(const std::array<double, 3>& place) {
  return std::ranges::all_of(place, [](double x) { return std::isfinite(x); });
}

void require_numbers(const Input& input) {
  if (std::isfinite(input.time) && std::isfinite(input.value) && is_finite(input.first) &&
      is_finite(input.second)) {
    return;
  }
  throw InputError(
      fmt::format("an input for \"{}\" has a value that is not finite; give numbers", input.name));
}

}  // namespace

void StepCosts::add(double seconds) {
  constexpr double most_over_median = 3;
  latest_[count_++ % latest_.size()] = seconds;
  std::array<double, 16> sorted = latest_;
  const std::size_t known = std::min(count_, sorted.size());
  std::sort(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(known));
  expected_ = std::min(sorted[known - 1], most_over_median * sorted[known / 2]);
}

std::size_t target_of(const Case& settings, const Input& input) {
  const bool is_cut = input.kind == Input::Kind::blade || input.kind == Input::Kind::lift;
  if (is_cut) return find(settings.cuts, input.name, "cut");
  return find(settings.boundaries, input.name, "boundary");
}

bool Session::has_come(double time) const { return solver_->clock().time >= time * (1 - rounding); }

void Session::enter(const Input& input) {
  require_numbers(input);
  if (has_come(input.time)) return apply(input);
  if (input.kind == Input::Kind::advance) {
    throw InputError("an advance cannot wait for its time: use play, or advance");
  }
  target_of(solver_->settings(), input);
  const auto after =
      std::upper_bound(waiting_.begin(), waiting_.end(), input.time,
                       [](double time, const Input& waiting) { return time < waiting.time; });
  waiting_.insert(after, input);
}

void Session::apply(Input input) {
  using enum Input::Kind;
  if (input.kind == advance) return;
  const std::size_t target = target_of(solver_->settings(), input);
  switch (input.kind) {
    case pressure:
      solver_->loads().set_pressure(target, input.value);
      break;
    case wall_velocity:
      solver_->loads().set_wall_velocity(target, input.first);
      break;
    case blade:
      blades_of(*solver_).put_blade(target, input.first, input.second);
      break;
    default:
      blades_of(*solver_).lift_blade(target);
  }
  input.time = solver_->clock().time;
  record_.push_back(std::move(input));
}

void Session::play(const std::vector<Input>& inputs) {
  for (const Input& input : inputs) {
    if (input.kind == Input::Kind::advance) {
      repeat(input.time, input.until);
    } else {
      advance(input.time, HUGE_VAL);
      enter(input);
    }
  }
}

void Session::take_step(double longest) {
  const double start = now();
  solver_->step(longest);
  costs_.add(now() - start);
}

void Session::repeat(double time, double until) {
  if (has_come(time)) return;
  while (!has_come(time)) take_step(until - solver_->clock().time);
  record_.push_back({.time = solver_->clock().time, .name = {}, .until = until});
}

void Session::step() {
  take_step(HUGE_VAL);
  const double time = solver_->clock().time;
  const bool follows = !record_.empty() && record_.back().kind == Input::Kind::advance &&
                       record_.back().until == HUGE_VAL;
  if (follows) {
    record_.back().time = time;
  } else {
    record_.push_back({.time = time, .name = {}, .until = HUGE_VAL});
  }
}

std::int64_t Session::run(double until, double deadline) {
  std::int64_t steps = 0;
  while (!has_come(until)) {
    if (steps > 0 && now() + costs_.expected() > deadline) break;
    take_step(until - solver_->clock().time);
    ++steps;
  }
  if (steps > 0) record_.push_back({.time = solver_->clock().time, .name = {}, .until = until});
  return steps;
}

Progress Session::advance(double until, double budget) {
  if (std::isnan(until) || std::isnan(budget) || (std::isinf(until) && std::isinf(budget))) {
    throw InputError(
        fmt::format("advance until {} s within {} s would never end; give a time", until, budget));
  }
  const double start = now(), deadline = start + budget;
  Progress progress;
  while (true) {
    while (!waiting_.empty() && has_come(waiting_.front().time)) {
      const Input input = waiting_.front();
      waiting_.erase(waiting_.begin());
      apply(input);
    }
    const double stop = waiting_.empty() ? until : std::min(until, waiting_.front().time);
    if (has_come(until)) break;
    if (progress.steps > 0 && now() + costs_.expected() > deadline) break;
    progress.steps += run(stop, deadline);
  }
  progress.lag = std::max(0., until - solver_->clock().time);
  if (has_come(until)) progress.lag = 0;
  progress.wall_time = now() - start;
  return progress;
}

}  // namespace pliant

#pragma once

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/remeshed/solver.hpp"
#include "engine/simulation/methods.hpp"
#include "tests/engine/case/written_case.hpp"

namespace pliant::test {

using Solver = remeshed::Solver<double, 2>;
using Body = remeshed::Body<double, 2>;
using LatticeView = remeshed::LatticeView<double, 2>;
using remeshed::Field;
using remeshed::Kind;
using Settings = std::vector<std::string>;

/// A case of the project, changed by settings as on the command line.
inline Case small_case(const std::string& name, const Settings& settings) {
  return read_case(std::filesystem::path(PLIANT_SOURCE_DIR) / "cases" / name, settings);
}

/// `settings` followed by `more`, which override them.
inline Settings operator+(Settings settings, const Settings& more) {
  settings.insert(settings.end(), more.begin(), more.end());
  return settings;
}

/// Takes steps of the length that the case prescribes.
inline void advance(Solver& solver, int steps) {
  for (int i = 0; i < steps; ++i) solver.step(HUGE_VAL);
}

/// Steps to `time`, whatever step the case prescribes.
template <int D>
void advance_until(remeshed::Solver<double, D>& solver, double time) {
  while (solver.clock().time < time * (1 - 1e-12)) solver.step(time - solver.clock().time);
}

/// The measurements of a case at its end.
template <int D = 2>
std::vector<double> values_at_end(const std::string& text) {
  const Case settings = tests::read_text(text);
  remeshed::Solver<double, D> solver(settings, {2, kernels::widest_supported()});
  advance_until(solver, settings.time.end);
  return solver.measure();
}

/// Calls f(slot, cell) for the slots of a population of kind `kind`.
template <class F>
void for_each(const remeshed::Population<double, 2>& population, Kind kind, F&& f) {
  for (const Block<2>& block : population.layout.blocks()) {
    population.layout.for_each_slot(block, [&](std::int64_t slot, const Cell<2>& cell) {
      if (population.kind[slot] == kind) f(slot, cell);
    });
  }
}

}  // namespace pliant::test

#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "engine/total_lagrangian/solver.hpp"
#include "tests/engine/case/written_case.hpp"

namespace pliant::test {

/// A block [0, 1] x [0, 1] (x [0, 1]) of neo-Hookean rubber, free on all sides.
inline std::string free_block(int dimension) {
  const std::string zeros = dimension == 2 ? "[0, 0]" : "[0, 0, 0]";
  const std::string ones = dimension == 2 ? "[1, 1]" : "[1, 1, 1]";
  return "method = \"total_lagrangian\"\ndimension = " + std::to_string(dimension) + R"(
discretisation = { spacing = 0.125 }
time = { end = 1, step = "cfl" }
[material.rubber]
model = "reduced_polynomial"
density = 1
coefficients = [10]
compressibility = 0.05
[[body]]
name = "block"
material = "rubber"
geometry = { shape = "box", lower = )" +
         zeros + ", upper = " + ones + " }\n";
}

/// The same block of a material with two constants, E = 30 and nu = 0.3.
inline std::string block_of_law(int dimension, const std::string& model) {
  return tests::with(tests::with(free_block(dimension), "model = \"reduced_polynomial\"",
                                 "model = \"" + model + '"'),
                     "coefficients = [10]\ncompressibility = 0.05",
                     "youngs_modulus = 30\npoissons_ratio = 0.3");
}

template <int D>
using LagrangianSolver = total_lagrangian::Solver<double, D>;

template <int D>
void advance_until(LagrangianSolver<D>& solver, double time) {
  while (solver.clock().time < time * (1 - 1e-12)) solver.step(time - solver.clock().time);
}

/// Calls f(slot, place in the undeformed body) for every particle.
template <int D, class F>
void for_each_particle(const total_lagrangian::Body<double, D>& body, F&& f) {
  for (const Block<D>& block : body.layout.blocks()) {
    body.layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
      if (body.is_particle(p)) f(p, body.place(p, cell));
    });
  }
}

}  // namespace pliant::test

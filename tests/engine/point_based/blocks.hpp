#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "engine/point_based/solver.hpp"
#include "tests/engine/case/written_case.hpp"

namespace pliant::test {

/// A block [0, 1] x [0, 1] (x [0, 1]) of neo-Hookean rubber, free on all sides.
inline std::string free_points(int dimension) {
  const std::string zeros = dimension == 2 ? "[0, 0]" : "[0, 0, 0]";
  const std::string ones = dimension == 2 ? "[1, 1]" : "[1, 1, 1]";
  return "method = \"point_based\"\ndimension = " + std::to_string(dimension) + R"(
discretisation = { spacing = 0.125 }
time = { end = 1, step = "cfl" }
[material.rubber]
model = "neo_hookean"
density = 1
youngs_modulus = 100
poissons_ratio = 0.3
[[body]]
name = "block"
material = "rubber"
geometry = { shape = "box", lower = )" +
         zeros + ", upper = " + ones + " }\n";
}

template <int D>
using PointSolver = point_based::Solver<double, D>;

template <int D>
void advance_until(PointSolver<D>& solver, double time) {
  while (solver.clock().time < time * (1 - 1e-12)) solver.step(time - solver.clock().time);
}

}  // namespace pliant::test

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
  return tests::rubber_case("point_based", dimension, "0.125", "1, step = \"cfl\"") + R"([[body]]
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

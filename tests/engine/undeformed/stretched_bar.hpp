#pragma once

#include <string>

#include "tests/engine/undeformed/loads.hpp"

/// The block [0, 1] x [0, 1] between two walls that stretch it by 2 %.
namespace pliant::test {

/// The walls allow slip or hold the block in all directions; the left one ends at x = `left`.
inline std::string stretching_walls(bool slip, const std::string& left) {
  return half_space("left", slip ? "kind = \"slip_wall\"" : "kind = \"fixed\"", "[" + left + ", 0]",
                    "[1, 0]") +
         half_space("right",
                    std::string("kind = ") + (slip ? "\"slip_wall\"" : "\"moving_wall\"") +
                        "\ndisplacement = [\"0.02*min(t, 1)\", 0]",
                    "[1, 0]", "[-1, 0]") +
         measurement("pull", "kind = \"wall_force\"\nboundary = \"right\"\naxis = \"x\"");
}

/// Force of the right wall once the block has come to rest [N/m].
template <class Solver>
double pull_of(Solver& solver) {
  advance_until(solver, 4);
  const double impulse = values(solver)["pull"], from = solver.clock().time;
  advance_until(solver, 4.5);
  return (values(solver)["pull"] - impulse) / (solver.clock().time - from);
}

}  // namespace pliant::test

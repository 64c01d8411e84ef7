#include <gtest/gtest.h>

#include "engine/remeshed/solver.hpp"
#include "tests/engine/remeshed/small_case.hpp"

// The paper's own scheme, docs/paper-scheme.md, where the paper shows it. Each bar is what a change
// may add to the figure of docs/validation before somebody looks.
namespace pliant::test {
namespace {

const Settings scheme_of_the_paper = {
    "discretisation.kernel=quartic_spline", "discretisation.dissipation=0",
    "remeshing.every=1",                    "remeshing.volume=conserved",
    "ghosts.treatment=averaged",            "remeshed.gradient=normalised",
    "remeshed.reinitialisation=first_order", "remeshed.determinant=remeshed"};

/// The value of each measurement at the end of a run.
std::vector<double> at_end_of(const Case& settings) {
  Solver solver(settings, {2, kernels::widest_supported()});
  const std::vector<double> start = solver.measure();
  advance_until(solver, settings.time.end);
  std::vector<double> values = solver.measure();
  for (std::size_t m = 0; m < values.size(); ++m) {
    if (settings.measurements[m].relative) values[m] /= start[m];
  }
  return values;
}

}  // namespace
}  // namespace pliant::test

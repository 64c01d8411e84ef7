#include <gtest/gtest.h>

#include "engine/remeshed/solver.hpp"
#include "tests/engine/remeshed/small_case.hpp"

// The scheme of the paper, docs/paper-scheme.md, for results shown in the paper. Each tolerance is
// the deviation from the figure of docs/validation that needs no review.
namespace pliant::test {
namespace {

const Settings scheme_of_the_paper = {"discretisation.kernel=quartic_spline",
                                      "discretisation.dissipation=0",
                                      "remeshing.every=1",
                                      "remeshing.volume=conserved",
                                      "ghosts.treatment=averaged",
                                      "remeshed.gradient=normalised",
                                      "remeshed.reinitialisation=first_order",
                                      "remeshed.determinant=remeshed",
                                      "remeshed.free_motion=remeshed"};

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

// 0.2440 m is exact; for 512 particles the paper has 0.138 m and the default scheme 0.2446 m.
TEST(paper_scheme, runs_the_compression_to_its_end_and_bulges_too_little_when_coarse) {
  const Settings coarse = {"discretisation.spacing=1/16", "time.step=5e-5"};
  for (const char* name : {"compression_linear", "compression_hyperelastic"}) {
    const std::vector<double> end = at_end_of(small_case(name, scheme_of_the_paper + coarse));
    EXPECT_NEAR(end[0], 0.168, 0.002) << name;
    EXPECT_LT(end[4], 0.99) << "the mass is not conserved at free surfaces";
  }
}

// The averaged ghosts turn more slowly than the surface and slow it down; the first-order
// reinitialisation wears it off. The default scheme keeps 1.0005.
TEST(paper_scheme, brakes_the_rotating_cylinder) {
  const Settings a_tenth = {"time.end=0.1", "time.step=1e-3"};
  EXPECT_NEAR(at_end_of(small_case("rotating_cylinder", scheme_of_the_paper + a_tenth))[0], 0.848,
              0.01);
}

}  // namespace
}  // namespace pliant::test

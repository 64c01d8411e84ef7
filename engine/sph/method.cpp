#include "engine/sph/method.hpp"

#include "engine/case/checks/check.hpp"
#include "engine/remeshed/observe/measure.hpp"
#include "engine/remeshed/setup/footprint.hpp"
#include "engine/remeshed/step_limits.hpp"
#include "engine/sph/parameters.hpp"
#include "engine/sph/solver.hpp"

namespace pliant::sph {

namespace {

// Plain SPH has no ghosts, no level set, and no nodes to which particles return.
void check(const Check& check) {
  const Case& a_case = check.a_case;
  refuse_tables(check, {"contact", "cut"});
  if (!a_case.boundaries.empty()) {
    check.problems.add(check.place("boundary", 0, "kind"),
                       "method \"sph\" has free surfaces and periodic cells only",
                       "remove the boundaries, or write method = \"remeshed\"");
  }
  refuse_prony_shear(check);
  refuse_measurements(check, remeshed::Measurer<double, 2>::is_measured_on_particles);
  if (a_case.output.surface) {
    check.problems.add(check.place("output", "surface"),
                       "surfaces need a level set, which method \"sph\" does not have",
                       "write surface = false");
  }
}

constexpr double default_cfl = 0.5;

StepLimits step_limits(const Case& a_case) { return remeshed::step_limits(a_case, default_cfl); }

}  // namespace

RegisteredMethod method() {
  return {{.word = "sph",
           .meaning =
               "plain SPH without ghosts or remeshing, the baseline of the paper (RP.25), (RP.26)",
           .check = check,
           .keys = visit_keys,
           .step_limits = step_limits,
           .footprint = remeshed::footprint,
           .shows_states_within_steps = true},
          make_solver<Solver>};
}

}  // namespace pliant::sph

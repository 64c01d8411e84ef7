#include "engine/remeshed/method.hpp"

#include "engine/case/check.hpp"
#include "engine/remeshed/observe/measure.hpp"
#include "engine/remeshed/solver.hpp"

namespace pliant::remeshed {

namespace {

// Between two remeshings a ghost stays on the side of a wall on which it started.
void check_contact_walls(const Check& check) {
  using Policy = decltype(Case::remeshing)::Policy;
  if (check.a_case.remeshing.policy != Policy::never) return;
  for (const BoundaryCase& boundary : check.a_case.boundaries) {
    if (boundary.kind != BoundaryCase::Kind::contact_wall) continue;
    check.problems.add(check.place("remeshing", "every"), "contact walls need remeshings",
                       "write every = \"adaptive\"");
    return;
  }
}

void check(const Check& check) {
  check_contact_walls(check);
  refuse_measurements(check, Measurer<double, 2>::is_measured);
}

}  // namespace

RegisteredMethod method() {
  return {{"remeshed",
           "Lagrangian particles that are remeshed; a level set follows the free surface", check},
          make_solver<Solver>};
}

}  // namespace pliant::remeshed

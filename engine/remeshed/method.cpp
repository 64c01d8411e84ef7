#include "engine/remeshed/method.hpp"

#include <fmt/format.h>

#include "engine/case/check.hpp"
#include "engine/remeshed/observe/measure.hpp"
#include "engine/remeshed/solver.hpp"

namespace pliant::remeshed {

namespace {

// Between two remeshings a ghost stays on the side of a wall on which it started.
void check_contact_steps(const Check& check) {
  using Policy = decltype(Case::remeshing)::Policy;
  if (check.a_case.remeshing.policy != Policy::never) return;
  for (const BoundaryCase& boundary : check.a_case.boundaries) {
    if (boundary.kind != BoundaryCase::Kind::contact_wall) continue;
    check.problems.add(check.place("remeshing", "every"), "contact walls need remeshings",
                       "write every = \"adaptive\"");
    return;
  }
}

void check_contact_walls(const Check& check) {
  const auto& boundaries = check.a_case.boundaries;
  for (std::size_t i = 0; i < boundaries.size(); ++i) {
    if (boundaries[i].kind != BoundaryCase::Kind::contact_wall) continue;
    if (boundaries[i].friction_coefficient) {
      check.problems.add(check.place("boundary", i, "friction"),
                         "method \"remeshed\" has no friction coefficient",
                         "write friction = \"frictionless\" or \"no_slip\"");
    }
    if (boundaries[i].geometry.kind == Shape::Kind::half_space ||
        !is_whole(boundaries[i].geometry, check.a_case.dimension)) {
      continue;
    }
    check.problems.add(check.place("boundary", i, "geometry"),
                       fmt::format("contact wall \"{}\" is not a half_space", boundaries[i].name),
                       "use a half_space: contact needs a plane wall in method remeshed");
  }
}

void check_tractions(const Check& check) {
  const Case& a_case = check.a_case;
  for (std::size_t i = 0; i < a_case.boundaries.size(); ++i) {
    const BoundaryCase& boundary = a_case.boundaries[i];
    if (boundary.kind != BoundaryCase::Kind::traction) continue;
    if (boundary.area != BoundaryCase::LoadedArea::present) {
      check.problems.add(check.place("boundary", i, "area"),
                         "method \"remeshed\" does not know the undeformed surface",
                         "write area = \"present\", or take method = \"total_lagrangian\"");
    }
    for (const Expression& component : boundary.traction) {
      if (!component.uses('x') && !component.uses('y') && !component.uses('z')) continue;
      check.problems.add(check.place("boundary", i, "traction"),
                         "method \"remeshed\" takes tractions that depend on t alone",
                         "leave out x, y and z, or take method = \"total_lagrangian\"");
      break;
    }
    if (a_case.ghosts == GhostTreatment::averaged) {
      check.problems.add(check.place("ghosts", "treatment"), "averaged ghosts carry no tractions",
                         "write treatment = \"linear\", or remove the key");
    }
  }
}

void check(const Check& check) {
  check_contact_steps(check);
  check_contact_walls(check);
  check_tractions(check);
  refuse_tables(check, {"cut"});
  refuse_models_of_points(check);
  refuse_measurements(check, Measurer<double, 2>::is_measured);
}

}  // namespace

RegisteredMethod method() {
  return {{"remeshed",
           "Lagrangian particles that are remeshed; a level set follows the free surface", check},
          make_solver<Solver>};
}

}  // namespace pliant::remeshed

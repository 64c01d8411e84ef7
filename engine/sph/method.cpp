#include "engine/sph/method.hpp"

#include <fmt/format.h>

#include "engine/case/check.hpp"
#include "engine/sph/solver.hpp"

namespace pliant::sph {

namespace {

bool needs_level_set(MeasurementCase::Kind kind) {
  using Kind = MeasurementCase::Kind;
  switch (kind) {
    case Kind::extent:
    case Kind::surface_distance:
    case Kind::mean_radius:
    case Kind::surface_area:
    case Kind::point_value:
      return true;
    default:
      return false;
  }
}

// Plain SPH has neither ghosts nor a level set, and no nodes to which its particles return.
void check(const Check& check) {
  const Case& a_case = check.a_case;
  refuse_tables(check, {"remeshing", "level_set", "ghosts", "contact"});
  if (!a_case.boundaries.empty()) {
    check.problems.add(check.place("boundary", 0, "kind"),
                       "method sph has free surfaces and periodic cells only",
                       "take the boundaries out, or method = \"remeshed\"");
  }
  for (std::size_t i = 0; i < a_case.measurements.size(); ++i) {
    const MeasurementCase& measurement = a_case.measurements[i];
    if (!needs_level_set(measurement.kind)) continue;
    check.problems.add(check.place("measurement", i, "kind"),
                       fmt::format("measurement \"{}\" needs a level set or remeshed particles, "
                                   "which method sph does not have",
                                   measurement.name),
                       "take it out, or measure displacements and conserved quantities");
  }
  if (a_case.output.surface) {
    check.problems.add(check.place("output", "surface"),
                       "surfaces need a level set, which method sph does not have",
                       "write surface = false");
  }
}

}  // namespace

RegisteredMethod method() {
  return {
      {"sph", "plain SPH without ghosts or remeshing, the baseline of the paper (RP.73), (RP.74)",
       check},
      make_solver<Solver>};
}

}  // namespace pliant::sph

#include "engine/total_lagrangian/method.hpp"

#include <fmt/format.h>

#include "engine/case/check.hpp"
#include "engine/total_lagrangian/observe/measure.hpp"
#include "engine/total_lagrangian/solver.hpp"

namespace pliant::total_lagrangian {

namespace {

void check_body(const Check& check, std::size_t i) {
  const BodyCase& body = check.a_case.bodies[i];
  if (body.stretch != Vector{1, 1, 1}) {
    check.problems.add(
        check.place("body", i, "stretch"), fmt::format("body \"{}\" starts stretched", body.name),
        "method total_lagrangian starts from rest: let walls or pressure stretch it");
  }
}

void check(const Check& check) {
  const Case& a_case = check.a_case;
  refuse_tables(check, {"remeshing", "level_set", "ghosts", "periodic", "contact", "cut"});
  for (std::size_t i = 0; i < a_case.bodies.size(); ++i) check_body(check, i);
  refuse_measurements(check, Measurer<double, 2>::is_measured);
  if (a_case.total_lagrangian.match_time_step && !a_case.time.step) {
    check.problems.add(check.place("total_lagrangian", "mass_scaling"),
                       "the mass can only be scaled to a given time step",
                       "give time.step in seconds, or mass_scaling as a number");
  }
}

}  // namespace

RegisteredMethod method() {
  return {{"total_lagrangian",
           "nodes and stress points of the undeformed body (TL.1), for slow loads", check},
          make_solver<Solver>};
}

}  // namespace pliant::total_lagrangian

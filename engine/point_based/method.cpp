#include "engine/point_based/method.hpp"

#include <fmt/format.h>

#include "engine/case/check.hpp"
#include "engine/point_based/observe/measure.hpp"
#include "engine/point_based/solver.hpp"

namespace pliant::point_based {

namespace {

void check_body(const Check& check, std::size_t i) {
  const BodyCase& body = check.a_case.bodies[i];
  if (body.material_as_given.model == MaterialCase::Model::linear) {
    check.problems.add(check.place("body", i, "material"),
                       fmt::format("body \"{}\" is not hyperelastic", body.name),
                       "method point_based takes model = \"neo_hookean\", \"st_venant_kirchhoff\" "
                       "or \"reduced_polynomial\"");
  } else if (!body.material_as_given.prony.ratios.empty()) {
    check.problems.add(check.place("body", i, "material"),
                       fmt::format("body \"{}\" relaxes in time", body.name),
                       "method point_based takes materials without prony");
  }
  if (body.stretch != Vector{1, 1, 1}) {
    check.problems.add(check.place("body", i, "stretch"),
                       fmt::format("body \"{}\" starts stretched", body.name),
                       "method point_based starts from rest: let walls stretch it");
  }
}

void check_cut(const Check& check, std::size_t i) {
  const CutCase& cut = check.a_case.cuts[i];
  if (!(cut.end > cut.start)) {
    check.problems.add(
        check.place("cut", i, "end"),
        fmt::format("cut \"{}\" ends at {}, and starts at {}", cut.name, cut.end, cut.start),
        "give an end after the start");
  }
  if (check.a_case.dimension == 3 && cut.from == cut.to) {
    check.problems.add(check.place("cut", i, "to"),
                       fmt::format("the edge of cut \"{}\" has no length", cut.name),
                       "give two different ends, from and to");
  }
}

void check(const Check& check) {
  const Case& a_case = check.a_case;
  refuse_tables(check, {"remeshing", "level_set", "ghosts", "periodic", "contact"});
  for (std::size_t i = 0; i < a_case.cuts.size(); ++i) check_cut(check, i);
  for (std::size_t i = 0; i < a_case.bodies.size(); ++i) check_body(check, i);
  refuse_measurements(check, Measurer<double, 2>::is_measured);
}

}  // namespace

RegisteredMethod method() {
  return {{"point_based",
           "nodes of the undeformed body with moving least squares (PB.3), in real time; "
           "hyperelastic materials only",
           check},
          make_solver<Solver>};
}

}  // namespace pliant::point_based

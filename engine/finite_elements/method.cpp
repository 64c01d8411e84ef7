#include "engine/finite_elements/method.hpp"

#include <fmt/format.h>

#include "engine/case/checks/check.hpp"
#include "engine/finite_elements/measure.hpp"
#include "engine/finite_elements/parameters.hpp"
#include "engine/finite_elements/solver.hpp"
#include "engine/point_based/footprint.hpp"
#include "engine/point_based/method.hpp"
#include "engine/point_based/nodes/place_nodes.hpp"
#include "engine/undeformed/default_cfl.hpp"
#include "engine/undeformed/slip_walls.hpp"

namespace pliant::finite_elements {

namespace {

void check(const Check& check) {
  const Case& a_case = check.a_case;
  refuse_tables(check, {"periodic", "cut"});
  for (std::size_t i = 0; i < a_case.bodies.size(); ++i) {
    point_based::check_body(check, i);
    if (point_based::has_elements(a_case.bodies[i].geometry)) continue;
    check.problems.add(
        check.place("body", i, "geometry"),
        fmt::format("body \"{}\" has no elements", a_case.bodies[i].name),
        "method \"finite_elements\" takes shape = \"mesh\" with a .msh or .vtk file of "
        "tetrahedra");
  }
  refuse_prony_shear(check);
  refuse_measurements(check, Measurer<double, 2>::is_measured);
}

// By a bound on the highest frequency of the elements, (FE.6).
StepLimits step_limits(const Case& a_case) {
  StepLimits limits;
  limits.stable_cfl = 1;
  limits.default_cfl = undeformed::default_cfl_of_nodes(a_case);
  return limits;
}

void warn(const Case& a_case, std::vector<std::string>& warnings) {
  undeformed::warn_of_elements_in_slip_walls(a_case, point_based::has_elements, warnings);
}

}  // namespace

RegisteredMethod method() {
  return {{.word = "finite_elements",
           .meaning = "tetrahedra of a mesh, total Lagrangian explicit dynamics (FE.1)",
           .check = check,
           .keys = visit_keys,
           .damping = damping_of<Parameters>,
           .step_limits = step_limits,
           .warn = warn,
           .footprint = point_based::footprint,
           .has_self_contact = true},
          make_solver<Solver>};
}

}  // namespace pliant::finite_elements

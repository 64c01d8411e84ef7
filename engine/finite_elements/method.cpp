#include "engine/finite_elements/method.hpp"

#include <fmt/format.h>

#include "engine/case/checks/check.hpp"
#include "engine/case/checks/resolution.hpp"
#include "engine/case/checks/thickness.hpp"
#include "engine/finite_elements/measure.hpp"
#include "engine/finite_elements/parameters.hpp"
#include "engine/finite_elements/solver.hpp"
#include "engine/method/initial_stress.hpp"
#include "engine/method/initial_velocity.hpp"
#include "engine/point_based/footprint.hpp"
#include "engine/point_based/method.hpp"
#include "engine/point_based/nodes/place_nodes.hpp"
#include "engine/point_based/walls_in_meshes.hpp"
#include "engine/undeformed/coarse_tools.hpp"
#include "engine/undeformed/default_cfl.hpp"
#include "engine/undeformed/linear_material.hpp"
#include "engine/undeformed/slip_walls.hpp"

namespace pliant::finite_elements {

namespace {

// Elements without averages have no memory.
void check_relaxation(const Check& check, std::size_t i) {
  const BodyCase& body = check.a_case.bodies[i];
  if (body.prony.empty() || parameters_of(check.a_case).pressure == ElementPressure::averaged) {
    return;
  }
  check.problems.add(check.place("body", i, "material"),
                     fmt::format("the pressure of body \"{}\" relaxes in time", body.name),
                     "give finite_elements.pressure = \"averaged\"");
}

void check(const Check& check) {
  const Case& a_case = check.a_case;
  refuse_tables(check, {"periodic", "cut"});
  for (std::size_t i = 0; i < a_case.bodies.size(); ++i) {
    point_based::check_body(check, i);
    check_relaxation(check, i);
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

// Measured in meshes of six tetrahedra to a cell: for a cantilever and a twisted bar of 3 to 16
// cells across, and for cubes of 5 and 8 cells that are pressed to 0.6 of their height between
// faces that hold them.
void warn_of_few_elements(const Case& a_case, std::vector<std::string>& warnings) {
  constexpr double bending = 2.3, torsion = 5, unmentioned = 0.015;
  constexpr double soft_ratio = 0.4, nearly_incompressible = 0.48, squeezed_unmentioned = 0.05;
  for (const BodyCase& body : a_case.bodies) {
    const double across = thickness(a_case, body) / resolution_of(a_case, body).size;
    const double share = 1 / (across * across);
    if (bending * share >= unmentioned) {
      warnings.push_back(fmt::format(
          "body `{}` is {:.2g} elements thick: linear tetrahedra resist bending by about {:.2g} % "
          "and torsion by {:.2g} % too much; use a finer mesh or method = \"point_based\"",
          body.name, across, 100 * bending * share, 100 * torsion * share));
    }
    const double ratio = poissons_ratio(body);
    const double squeezed = (ratio < nearly_incompressible ? 1 : 2) / across;
    if (ratio < soft_ratio || squeezed < squeezed_unmentioned) continue;
    warnings.push_back(fmt::format(
        "body `{}` is {:.2g} elements thick, and Poisson's ratio is {:.3g}: where it is "
        "squeezed, forces are up to {:.0f} % too large; use a finer mesh or method = "
        "\"point_based\"",
        body.name, across, ratio, 100 * squeezed));
  }
}

void warn(const Case& a_case, std::vector<std::string>& warnings) {
  warn_of_few_elements(a_case, warnings);
  // Measured for bonded punches and a block that hangs from a box in its corner, of six tetrahedra
  // to a cell.
  static constexpr NarrowToolError attached[] = {{4.7, 25}, {6.6, 17}, {9.3, 13}, {13, 10}};
  undeformed::warn_of_coarse_tools(a_case, attached, warnings);
  undeformed::warn_of_equation_of_state(a_case, warnings);
  undeformed::warn_of_elements_in_slip_walls(a_case, point_based::has_elements, warnings);
  point_based::warn_of_walls_in_meshes(a_case, warnings);
  // Measured for a cube of 12 cells with four velocities.
  warn_of_initial_motion(a_case, {.boxes = 1.15, .others = 1.15}, warnings);
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
           .has_elements = point_based::has_elements,
           .has_self_contact = true},
          make_solver<Solver>};
}

}  // namespace pliant::finite_elements

#include "engine/point_based/method.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/boundaries/overhanging_bodies.hpp"
#include "engine/case/blade_track.hpp"
#include "engine/case/checks/check_motion.hpp"
#include "engine/case/checks/hollows.hpp"
#include "engine/case/checks/narrow_places.hpp"
#include "engine/case/checks/thickness.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/method/initial_stress.hpp"
#include "engine/method/initial_velocity.hpp"
#include "engine/point_based/coarse_points.hpp"
#include "engine/point_based/cutting/cut_resolution.hpp"
#include "engine/point_based/footprint.hpp"
#include "engine/point_based/nodes/place_nodes.hpp"
#include "engine/point_based/observe/measure.hpp"
#include "engine/point_based/parameters.hpp"
#include "engine/point_based/solver.hpp"
#include "engine/point_based/walls_in_meshes.hpp"
#include "engine/point_based/walls_off_the_lattice.hpp"
#include "engine/undeformed/coarse_tools.hpp"
#include "engine/undeformed/default_cfl.hpp"
#include "engine/undeformed/linear_material.hpp"
#include "engine/undeformed/round_bodies.hpp"
#include "engine/undeformed/slip_walls.hpp"
#include "engine/undeformed/squeezed_bodies.hpp"

namespace pliant::point_based {

namespace {

void check_cut(const Check& check, std::size_t i) {
  const CutCase& cut = check.a_case.cuts[i];
  if (!cut.track.file.empty()) return;
  for (const std::string_view key : {"from", "path", "end"}) {
    if (check.root["cut"][i][key]) continue;
    check.problems.add(check.place("cut", i, key),
                       fmt::format("cut \"{}\" lacks the key `{}`", cut.name, key),
                       "give from, path and end, or a track");
    return;
  }
  if (!(cut.end > cut.start)) {
    check.problems.add(
        check.place("cut", i, "end"),
        fmt::format("cut \"{}\" ends at {}, and starts at {}", cut.name, cut.end, cut.start),
        "give an end after the start");
  }
  const BladeEdge start = edge_of(cut, cut.start);
  if (check.a_case.dimension == 3 && start.from == start.to) {
    check.problems.add(check.place("cut", i, "to"),
                       fmt::format("the edge of cut \"{}\" has no length", cut.name),
                       "give two different ends, from and to");
  }
  if (check.a_case.dimension == 2 && check.root["cut"][i]["to"] && start.from != start.to) {
    check.problems.add(check.place("cut", i, "to"),
                       fmt::format("the edge of cut \"{}\" is a point in 2D", cut.name),
                       "leave `to` out; `path` says where the point goes");
  }
  if (!moves_in_run(cut, check.a_case)) return;
  check_start_of_motion(check, check.place("cut", i, "path"),
                        fmt::format("the path of cut \"{}\"", cut.name), cut.path, cut.start);
}

void check_nodes(const Check& check) {
  const Case& a_case = check.a_case;
  const Parameters& given = parameters_of(a_case);
  const int asked = given.neighbours, least = a_case.dimension + 1;
  if (asked > 0 && asked < least) {
    check.problems.add(
        check.place("point_based", "neighbours"),
        fmt::format("{} neighbours are too few for a gradient in {}D", asked, a_case.dimension),
        fmt::format("give {} or more, or 0 for the default", least));
  }
}

void check_octree(const Check& check) {
  const double coarsest = parameters_of(check.a_case).coarsest_spacing,
               spacing = check.a_case.discretisation.spacing;
  if (coarsest > 0 && coarsest < spacing) {
    check.problems.add(
        check.place("point_based", "coarsest_spacing"),
        fmt::format("the coarsest spacing {} is below the spacing {}", coarsest, spacing),
        "give a larger one, or 0 for four times the spacing");
  }
}

void check(const Check& check) {
  const Case& a_case = check.a_case;
  check_nodes(check);
  check_octree(check);
  refuse_tables(check, {"periodic"});
  for (std::size_t i = 0; i < a_case.cuts.size(); ++i) check_cut(check, i);
  for (std::size_t i = 0; i < a_case.bodies.size(); ++i) check_body(check, i);
  refuse_measurements(check, Measurer<double, 2>::is_measured);
}

/// Whether forces other than those of bonds act on single nodes. Their fast motion then holds a
/// share of the energy that grows with the square of the step.
bool has_forces_on_single_nodes(const Case& a_case) {
  return parameters_of(a_case).cut_contact.has_value() ||
         std::ranges::any_of(
             a_case.cuts,
             [](const CutCase& cut) { return cut.resists() || cut.puncture_force > 0; }) ||
         std::ranges::any_of(a_case.bodies,
                             [](const BodyCase& body) { return body.stress.has_value(); });
}

// Measured for squares between plates, docs/decisions/0043, and cantilevers, with Poisson's ratios
// of 0.45 and 0.49.
void warn_of_squeezed_lattices(const Case& a_case, std::vector<std::string>& warnings) {
  constexpr double least_ratio = 0.44, unmentioned = 0.03;
  if (a_case.dimension == 3 || parameters_of(a_case).nodes != NodePlacement::lattice) return;
  for (const BodyCase& body : a_case.bodies) {
    const Box<3> box = bounding_box(body.geometry);
    const double size = std::min(box.upper[0] - box.lower[0], box.upper[1] - box.lower[1]);
    const double across = size / a_case.discretisation.spacing;
    const double ratio = poissons_ratio(body);
    // Of one spacing across: 0.42 and 1.
    const double error = (0.42 + 14.5 * std::max(ratio - 0.45, 0.0)) / across;
    if (has_elements(body.geometry) || error < unmentioned || ratio < least_ratio) continue;
    warnings.push_back(fmt::format(
        "body `{}` has {:.2g} spacings across, and Poisson's ratio is {:.3g}: where it is "
        "squeezed or bent, it is {:.0f} % too stiff or more; use a finer spacing, "
        "point_based.nodes = \"octree\", or method = \"total_lagrangian\"",
        body.name, across, ratio, 100 * error));
  }
}

void warn(const Case& a_case, std::vector<std::string>& warnings) {
  warn_of_coarse_points(a_case, warnings);
  warn_of_coarse_cuts(a_case, warnings);
  warn_of_squeezed_lattices(a_case, warnings);
  // Measured for blocks, beams and an L that hang from a box in their corner: edges of the box are
  // up to half a spacing from the last node that it holds.
  static constexpr NarrowToolError holding_box[] = {{6.5, 21}, {22, 16}};
  undeformed::warn_of_coarse_tools(a_case, holding_box, warnings);
  undeformed::warn_of_equation_of_state(a_case, warnings);
  // Measured for squares, discs and balls that rotate or are sheared.
  warn_of_initial_motion(a_case, {.boxes = 1, .others = 1.1}, warnings);
  // Measured for cubes between plates that press them to 0.75 and 0.6 of their height, with
  // Poisson's ratios of 0.4 to 0.49.
  static constexpr ThinBodyError squeezed[] = {
      {6.5, "where walls that hold it squeeze it, forces are 4 to 9 % too large"},
      {8.5, "where walls that hold it squeeze it, forces are 2 to 5 % too large"}};
  undeformed::warn_of_squeezed_bodies(a_case, squeezed, warnings);
  undeformed::warn_of_elements_in_slip_walls(a_case, has_elements, warnings);
  warn_of_walls_in_meshes(a_case, warnings);
  const bool have_elements = std::ranges::any_of(
      a_case.bodies, [](const BodyCase& body) { return has_elements(body.geometry); });
  if (have_elements) return;
  warn_of_walls_off_the_lattice(a_case, warnings);
  // Measured for discs and balls between plates, docs/decisions/0082.
  static constexpr ThinBodyError pressed[] = {
      {4.5, "forces on its round parts deviate by up to 40 % where it touches something"},
      {5.5, "forces on its round parts deviate by up to 27 % where it touches something"},
      {7.5, "forces on its round parts deviate by up to 17 % where it touches something"},
      {9.5, "forces on its round parts deviate by up to 10 % where it touches something"},
      {12.5, "forces on its round parts deviate by up to 6 % where it touches something"}};
  undeformed::warn_of_round_bodies(a_case, pressed, warnings);
  // Measured for holes in plates and for cavities, docs/decisions/0082.
  static constexpr ThinBodyError hollows[] = {
      {3.5, "stresses around it deviate by up to 30 % of the largest one"},
      {4.5, "stresses around it deviate by up to 20 % of the largest one"},
      {6.5, "stresses around it deviate by up to 15 % of the largest one"},
      {9, "stresses around it deviate by up to 11 % of the largest one"}};
  warn_of_small_hollows(a_case, hollows, warnings);
  // Measured for slots in blocks, docs/decisions/0090.
  static constexpr ThinBodyError gaps[] = {{1.3, "it may act as if it were closed"},
                                           {2, "displacements beside it are up to 20 % too small"}};
  warn_of_narrow_gaps(a_case, gaps, warnings);
  // Measured for fins of blocks, docs/decisions/0090.
  static constexpr ThinBodyError thin_parts[] = {
      {1.8, "it bends up to 60 % too little, or the run stops"},
      {3.5, "it bends up to 25 % too little"}};
  warn_of_thin_parts(a_case, thin_parts, warnings);
  // Measured for trapezoids, and discs and balls held by a cap, docs/decisions/0078.
  static constexpr ThinBodyError held_by_a_cap[] = {
      {8.5, "forces and displacements deviate by up to 13 %, as it overhangs a wall that holds it"},
      {16.5,
       "forces and displacements deviate by up to 9 %, as it overhangs a wall that holds it"}};
  warn_of_overhangs(a_case, held_by_a_cap, warnings);
}

// The bound of (PB.12) needs the nodes, which only the solver has.
StepLimits step_limits(const Case& a_case) {
  StepLimits limits;
  limits.stable_cfl = 1;
  limits.default_cfl =
      has_forces_on_single_nodes(a_case) ? 0.3 : undeformed::default_cfl_of_nodes(a_case);
  return limits;
}

}  // namespace

void check_body(const Check& check, std::size_t i) {
  const BodyCase& body = check.a_case.bodies[i];
  if (body.stretch != Vector{1, 1, 1}) {
    check.problems.add(
        check.place("body", i, "stretch"), fmt::format("body \"{}\" starts stretched", body.name),
        fmt::format("method \"{}\" starts from rest: let walls stretch it", check.a_case.method));
  }
}

RegisteredMethod method() {
  return {{.word = "point_based",
           .meaning = "nodes of the undeformed body with moving least squares (PB.3), in real time",
           .check = check,
           .keys = visit_keys,
           .damping = damping_of<Parameters>,
           .step_limits = step_limits,
           .warn = warn,
           .footprint = footprint,
           .has_elements = has_elements,
           .has_self_contact = true},
          make_solver<Solver>};
}

}  // namespace pliant::point_based

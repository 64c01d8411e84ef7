#include "engine/total_lagrangian/method.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "engine/boundaries/overhanging_bodies.hpp"
#include "engine/case/checks/check.hpp"
#include "engine/case/checks/hollows.hpp"
#include "engine/case/checks/measured_edges.hpp"
#include "engine/case/checks/narrow_places.hpp"
#include "engine/case/checks/thickness.hpp"
#include "engine/geometry/plane_across.hpp"
#include "engine/method/initial_velocity.hpp"
#include "engine/total_lagrangian/observe/measure.hpp"
#include "engine/total_lagrangian/parameters.hpp"
#include "engine/total_lagrangian/solver.hpp"
#include "engine/undeformed/coarse_tools.hpp"
#include "engine/undeformed/round_bodies.hpp"
#include "engine/undeformed/squeezed_bodies.hpp"
#include "kernels/total_lagrangian/arguments.hpp"

namespace pliant::total_lagrangian {

namespace {

void check_body(const Check& check, std::size_t i) {
  const BodyCase& body = check.a_case.bodies[i];
  if (body.stretch != Vector{1, 1, 1}) {
    check.problems.add(
        check.place("body", i, "stretch"), fmt::format("body \"{}\" starts stretched", body.name),
        "method \"total_lagrangian\" starts from rest: let walls or pressure stretch it");
  }
}

void check(const Check& check) {
  const Case& a_case = check.a_case;
  refuse_tables(check, {"periodic", "cut"});
  for (std::size_t i = 0; i < a_case.bodies.size(); ++i) check_body(check, i);
  refuse_measurements(check, Measurer<double, 2>::is_measured);
  if (!parameters_of(a_case).mass_scaling && !a_case.time.step) {
    check.problems.add(check.place("total_lagrangian", "mass_scaling"),
                       "the mass can only be scaled to a given time step",
                       "give time.step in seconds, or mass_scaling as a number");
  }
}

// Stability limit (TL.9).
StepLimits step_limits(const Case& a_case) {
  const std::optional<double>& scaling = parameters_of(a_case).mass_scaling;
  StepLimits limits;
  limits.stable_cfl = 1;
  // At 0.5, 0.7 and 0.9, the total energy of free plates (amplitude and thickness 0.2 of the
  // length, 5 particles across) varies by 0.16, 0.47 and 0.69 %. Blocks that stick together on a
  // slope create 1.2 % of the work of gravity at 0.6, less than 1 % at 0.5.
  limits.default_cfl = a_case.contacts.empty() ? 0.7 : 0.5;
  limits.bounds_given_steps = true;
  limits.mass_follows_step = !scaling;
  limits.mass_scaling = scaling.value_or(1);
  return limits;
}

std::string summary(const Case& a_case) {
  const std::optional<double>& scaling = parameters_of(a_case).mass_scaling;
  return scaling ? fmt::format("the mass times {}", *scaling) : "the mass scaled to the step";
}

bool has_inclined_side(const Shape& shape) {
  if (shape.kind == Shape::Kind::half_space) return !is_plane_along_lattice(shape);
  return std::ranges::any_of(shape.operands, has_inclined_side);
}

bool turns_a_wall(const Case& a_case) {
  return std::ranges::any_of(a_case.boundaries,
                             [](const BoundaryCase& wall) { return wall.rotation.has_value(); });
}

// Thin: cantilevers and the torsion of a bar with one cell across, docs/decisions/0027. Inclined:
// beams and brackets at 10 to 45 degrees to the lattice, docs/decisions/0038. Twisted: square and
// round bars, four times as long as thick, between walls. Narrow: the aspirated liver with 4.8 and
// 5.6 cells across the hole, where the particle in the middle rises 14 to 21 % and 10 % too little.
void warn_of_thin_parts(const Case& a_case, std::vector<std::string>& warnings) {
  static constexpr ThinBodyError thin[] = {
      {1.5, "bending deviates by 3 %, and the period of torsion by 40 %"}};
  static constexpr ThinBodyError inclined[] = {
      {2.5, "it bends 20 to 30 % too little, as its sides lie at an angle to the lattice"},
      {4.5, "it bends 7 to 15 % too little, as its sides lie at an angle to the lattice"},
      {5.5, "it bends 3 to 10 % too little, as its sides lie at an angle to the lattice"},
      {10.5, "it bends up to 8 % too little, as its sides lie at an angle to the lattice"}};
  static constexpr ThinBodyError twisted[] = {
      {3.5, "walls that twist it meet up to 14 % too much moment"},
      {4.5, "walls that twist it meet up to 9 % too much moment"},
      {6.5, "walls that twist it meet up to 6 % too much moment"}};
  static constexpr ThinBodyError narrow[] = {{6, "its displacement deviates by 10 to 20 %"}};
  const auto is_inclined = [](const BodyCase& body) { return has_inclined_side(body.geometry); };
  warn_of_thin_bodies(a_case, thin, warnings, std::not_fn(is_inclined));
  warn_of_thin_bodies(a_case, inclined, warnings, is_inclined);
  if (a_case.dimension == 3 && turns_a_wall(a_case)) warn_of_thin_bodies(a_case, twisted, warnings);
  warn_of_narrow_openings(a_case, narrow, warnings);
}

void warn(const Case& a_case, std::vector<std::string>& warnings) {
  warn_of_thin_parts(a_case, warnings);
  // Measured for discs and balls held by a cap, docs/decisions/0078.
  static constexpr ThinBodyError held_by_a_cap[] = {
      {10.5,
       "forces and displacements deviate by up to 9 %, as it overhangs a wall that holds it"}};
  warn_of_overhangs(a_case, held_by_a_cap, warnings);
  // Measured for cubes between plates that press them to 0.75 and 0.6 of their height, with
  // Poisson's ratios of 0.4 to 0.49.
  static constexpr ThinBodyError squeezed[] = {
      {5.5, "where walls that hold it squeeze it, forces are 4 to 16 % too large"},
      {6.5, "where walls that hold it squeeze it, forces are 3 to 8 % too large"},
      {8.5, "where walls that hold it squeeze it, forces are up to 5 % too large"}};
  undeformed::warn_of_squeezed_bodies(a_case, squeezed, warnings);
  undeformed::warn_of_coarse_tools(a_case, undeformed::bonded_punches, warnings);
  // Measured for discs and balls between plates, docs/decisions/0082.
  static constexpr ThinBodyError pressed[] = {
      {4.5, "forces on its round parts deviate by up to 40 % where it touches something"},
      {7.5, "forces on its round parts deviate by up to 10 % where it touches something"},
      {10.5, "forces on its round parts deviate by up to 5 % where it touches something"}};
  undeformed::warn_of_round_bodies(a_case, pressed, warnings);
  // Measured for holes in plates and for cavities, docs/decisions/0082.
  static constexpr ThinBodyError hollows[] = {
      {3.5, "stresses around it deviate by up to 16 % of the largest one"},
      {4.5, "stresses around it deviate by up to 12 % of the largest one"},
      {6.5, "stresses around it deviate by up to 10 % of the largest one"},
      {9, "stresses around it deviate by up to 5 % of the largest one"}};
  warn_of_small_hollows(a_case, hollows, warnings);
  // Measured for slots in blocks, docs/decisions/0090.
  static constexpr ThinBodyError gaps[] = {
      {2.1, "it may act as if it were closed"},
      {2.7, "displacements beside it are up to 20 % too small"}};
  warn_of_narrow_gaps(a_case, gaps, warnings);
  // Measured for fins of blocks, docs/decisions/0090.
  static constexpr ThinBodyError thin_parts[] = {{2.5, "it bends up to 40 % too little"},
                                                 {3.5, "it bends up to 13 % too little"}};
  warn_of_thin_parts(a_case, thin_parts, warnings);
  // Measured for turned blocks, docs/decisions/0083.
  warn_of_measured_edges(a_case,
                         "there stresses deviate by up to 40 % and displacements by up to 14 % of "
                         "the largest ones in this method",
                         warnings);
  // Measured for squares, discs and balls that rotate or are sheared.
  warn_of_initial_motion(a_case, {.boxes = 1, .others = 2}, warnings);
}

// Particles lie on the corners of all cells that the body fills, wholly or in part.
Footprint footprint(const Case& a_case, const BodyCase& body) {
  // Scalars: phi, fraction, that of regular cells, mass and its inverse. Five vectors. Twice: p_i
  // and J - 1, A_i and C^-1.
  const int dimension = a_case.dimension;
  const std::size_t terms = body.prony.size();
  const std::size_t networks = body.prony_shear.size();
  const int components = dimension == 2 ? 4 : 6;
  const double memory =
      (terms > 0 ? terms + 1.0 : 0.0) + (networks > 0 ? components * (networks + 1.0) : 0.0);
  Footprint footprint;
  footprint.on_corners = true;
  footprint.margin = 0.5;
  footprint.reach = 1.8;
  footprint.bytes_per_slot = sizeof(double) * (5.0 + 2 * memory + 5 * dimension);
  footprint.bytes_per_particle = dimension == 2 ? 170 : 450;
  return footprint;
}

}  // namespace

RegisteredMethod method() {
  return {{.word = "total_lagrangian",
           .meaning = "nodes and stress points of the undeformed body (TL.1), for slow loads",
           .check = check,
           .keys = visit_keys,
           .damping = damping_of<Parameters>,
           .step_limits = step_limits,
           .summary = summary,
           .warn = warn,
           .footprint = footprint,
           .has_self_contact = true},
          make_solver<Solver>};
}

}  // namespace pliant::total_lagrangian

#pragma once

#include <fmt/format.h>

#include "engine/case/vocabulary/body_keys.hpp"
#include "engine/case/vocabulary/boundary_keys.hpp"
#include "engine/case/vocabulary/cut_keys.hpp"
#include "engine/case/vocabulary/key.hpp"
#include "engine/case/vocabulary/material_keys.hpp"
#include "engine/case/vocabulary/measurement_keys.hpp"
#include "engine/case/vocabulary/method_keys.hpp"
#include "engine/case/vocabulary/words.hpp"

/// The vocabulary of case files: every key with its place in `Case`, unit, limits and meaning.
/// Three visitors use it: one reads and checks a file, one writes `case.resolved.toml`, one writes
/// the reference. A visitor has
///
///     bool visit(key, value, notes)         false: the value is not usable
///     void visit.table(key, meaning, keys)            [key]
///     void visit.optional_table(key, meaning, present, keys)
///     void visit.list(key, meaning, elements, keys)   [[key]]
///     void visit.materials(key, meaning)              [key.NAME]
///     int visit.dimension()
///     MethodList visit.methods()
///
/// A method declares the keys of its own table, see method_rules.hpp.
namespace pliant {

template <class Visitor>
void remeshing_keys(Visitor& visit, decltype(Case::remeshing)& remeshing) {
  visit("every", RemeshRule{remeshing},
        {.meaning =
             R"(number of time steps between two remeshings, "adaptive" (RP.39; with contact )"
             R"(after ten steps at the latest while bodies move; in 2D see (RP.108)) or "never")",
         .unit = "steps",
         .example = "10",
         .limits = at_least_one});
  visit("strain_threshold", remeshing.strain_threshold,
        {.meaning = R"(strain since the last remeshing at which every = "adaptive" remeshes; by )"
                    "default 0.4 where walls or loads act on tied bodies",
         .example = "0.2",
         .limits = {0, 1, false, true, "above 0 and at most 1"}});
  visit(
      "deformation_threshold", remeshing.deformation_threshold,
      {.meaning = R"(deformation abs(F - I) since the last remeshing, rotation included, at which )"
                  R"(every = "adaptive" remeshes; by default 1 where walls or loads act on tied )"
                  "bodies",
       .example = "0.2",
       .limits = {0, 1, false, true, "above 0 and at most 1"}});
  visit("filter", remeshing.filter,
        {.meaning = "strength of the high-order filter (RP.37); 0 switches it off",
         .example = "0.2",
         .limits = {0, 1, true, true, "from 0 to 1"}});
  visit("volume", remeshing.volume,
        {.meaning = "volume of remeshed particles", .example = R"("reset")"});
}

template <class Visitor>
void periodic_keys(Visitor& visit, decltype(Case::periodic)& periodic) {
  visit("axes", AxisSet{periodic.axis},
        {.meaning = "directions in which the domain is periodic",
         .example = R"(["x", "y"])",
         .required = true});
  visit("lower", periodic.lower,
        {.meaning =
             "lower corner of the periodic cell; components along other directions have no effect",
         .unit = "m",
         .example = "[0, 0]",
         .limits = finite_or_infinite,
         .required = true});
  visit("upper", periodic.upper,
        {.meaning = "upper corner; the period must be a multiple of the spacing",
         .unit = "m",
         .example = "[1, 1]",
         .limits = finite_or_infinite,
         .required = true});
}

template <class Visitor>
void output_keys(Visitor& visit, decltype(Case::output)& output) {
  visit("every", output.every,
        {.meaning = "time between two frames; 0 writes the first and the last only",
         .unit = "s",
         .example = "0.001",
         .limits = not_negative});
  visit("checkpoint_every", output.checkpoint_every,
        {.meaning = "time between two checkpoints; 0 writes one with every frame",
         .unit = "s",
         .example = "0.01",
         .limits = not_negative});
  visit("ghosts", output.ghosts,
        {.meaning = "whether frames contain the ghost particles", .example = "false"});
  visit("surface", output.surface,
        {.meaning = "whether frames contain the closed surface of every body as a mesh "
                    "(surface.xdmf)",
         .example = "false"});
  visit("measure_every", output.measure_every,
        {.meaning =
             "time between two samples of the measurements; 0 takes one at every remeshing and "
             "at the end, or a hundred in a run (eight or more steps apart) if measurements depend "
             "on samples (forces, moments and those of histories)",
         .unit = "s",
         .example = "0.001",
         .limits = not_negative});
}

template <class Visitor>
void time_keys(Visitor& visit, decltype(Case::time)& time, bool remeshes) {
  visit("end", time.end,
        {.meaning = "time at which the run ends",
         .unit = "s",
         .example = "0.02",
         .limits = positive,
         .required = true});
  visit("step", NumberOrWord{time.step, "cfl", "a time step"},
        {.meaning = R"(time step, or "cfl" to derive it from the wave speed (RP.29))",
         .unit = "s",
         .example = "5e-5",
         .limits = positive});
  visit("cfl", CflRule{time.cfl},
        {.meaning =
             R"(CFL number for step = "cfl"; by default 1 in the remeshed method, 0.7 in the )"
             "total Lagrangian one (in both 0.5 with contact between bodies), 0.5 with plain SPH, "
             "0.9 with finite elements and point-based nodes (0.6 with contact; 0.3 "
             "where blades, faces of cuts or initial stresses push nodes)",
         .example = "0.5",
         .limits = {0, 2, false, true, "above 0 and at most 2"}});
  if (!remeshes) return;
  visit("strain", time.strain,
        {.meaning = R"(largest strain in one step, dt max abs(eps), for step = "cfl" (RP.29))",
         .example = "0.02",
         .limits = {0, 1, false, true, "above 0 and at most 1"}});
}

inline constexpr Limits strength_of_dissipation{0, 2, true, true, "from 0 to 2"};

template <class Visitor>
void dissipation_keys(Visitor& visit, DissipationCase& dissipation) {
  visit(
      "velocity", dissipation.velocity,
      {.meaning = "strength in the velocity", .example = "0.5", .limits = strength_of_dissipation});
  visit("stress", dissipation.stress,
        {.meaning = "strength in the stress; it costs more energy than that in the velocity",
         .example = "0.025",
         .limits = strength_of_dissipation});
}

template <class Visitor>
void discretisation_keys(Visitor& visit, decltype(Case::discretisation)& discretisation,
                         bool remeshes, bool has_damping) {
  visit("spacing", discretisation.spacing,
        {.meaning = "initial distance h between particles, the resolution",
         .unit = "m",
         .example = "0.03125",
         .limits = positive,
         .required = true});
  if (remeshes || has_damping) {
    visit("damping", NumberOrWord{discretisation.damping, "adaptive", "a rate"},
          {.meaning = R"(mass-proportional damping rate (RP.71), (TL.8), (PB.10), or "adaptive" )"
                      "for critical damping of the present motion (RP.88), (TL.10), (PB.65), for "
                      "bodies that come to rest; a rate in the table of a method comes first",
           .unit = "1/s",
           .example = "0.5",
           .limits = not_negative});
  }
  if (!remeshes) return;
  visit("kernel", discretisation.kernel,
        {.meaning = "smoothing kernel of the gradients", .example = R"("compact")"});
  visit(
      "dissipation", Dissipation{discretisation.dissipation},
      {.meaning = "damping of modes that the lattice does not resolve (RP.23), see dissipation; a "
                  "number stands for both strengths; free surfaces need it in long runs",
       .example = "{ velocity = 0.5, stress = 0.025 }",
       .limits = strength_of_dissipation});
}

template <class Visitor>
void check_keys(Visitor& visit, decltype(Case::checks)& checks) {
  visit("energy", checks.energy,
        {.meaning = "response to energy that is created without work", .example = R"("stop")"});
  visit("mass", checks.mass,
        {.meaning = "response to mass that is created or lost", .example = R"("stop")"});
  visit("momentum", checks.momentum,
        {.meaning = "response to momentum that is created where nothing acts on the bodies",
         .example = R"("stop")"});
}

/// The tables of the methods. Tables of other methods are read too, and refused later.
template <class Visitor>
void method_tables(Visitor& visit, Case& a_case) {
  for (const MethodRules& method : visit.methods()) {
    if (method.keys == nullptr) continue;
    visit.optional_table(method.word, fmt::format("Parameters of method = \"{}\".", method.word),
                         &method == a_case.rules, [&](auto& keys) {
                           MethodKeysFor for_method(keys);
                           method.keys(for_method, a_case.parameters);
                         });
  }
}

template <class Visitor>
void case_keys(Visitor& visit, Case& a_case) {
  visit("title", a_case.title,
        {.meaning = "title of the case, one line", .example = R"("A case")"});
  visit("name", Name{a_case.name},
        {.meaning =
             "name of the case; by default the name of the file, or of the folder of a case.toml",
         .example = R"("compression")"});
  visit("dimension", a_case.dimension,
        {.meaning = "2 (plane strain) or 3; the number of components of vectors",
         .example = "2",
         .limits = {2, 3, true, true, "2 or 3"}});
  visit("method", MethodWord{a_case.method, visit.methods()},
        {.meaning = "numerical method", .example = R"("remeshed")"});
  a_case.rules = rules_of(visit.methods(), a_case.method);
  const bool remeshes = is_remeshed(a_case);
  const bool has_damping = a_case.rules != nullptr && a_case.rules->damping != nullptr;
  visit("precision", a_case.precision,
        {.meaning = "precision of the fields; clocks, sums and measurements are double",
         .example = R"("double")"});
  visit("gravity", a_case.gravity,
        {.meaning = "acceleration of all bodies by a body force, numbers or formulas of x, y, z, t",
         .unit = "m/s^2",
         .example = "[0, -9.81]"});
  visit.table("discretisation", "Resolution and spatial operators.", [&](auto& keys) {
    discretisation_keys(keys, a_case.discretisation, remeshes, has_damping);
  });
  visit.table("time", "Simulated time and time step.",
              [&](auto& keys) { time_keys(keys, a_case.time, remeshes); });
  visit.optional_table("remeshing", "Remeshing of the particles onto their lattice.", remeshes,
                       [&](auto& keys) { remeshing_keys(keys, a_case.remeshing); });
  visit.optional_table(
      "level_set", "Level set that represents the free surface.", remeshes, [&](auto& keys) {
        keys(
            "reinitialise_every", a_case.level_set.reinitialise_every,
            {.meaning = "number of time steps between two reinitialisations of the signed distance",
             .unit = "steps",
             .example = "20",
             .limits = at_least_one});
      });
  visit.optional_table(
      "ghosts", "Ghost particles, which impose the boundary conditions from outside the body.",
      remeshes, [&](auto& keys) {
        keys("treatment", a_case.ghosts,
             {.meaning = "extrapolation of their values", .example = R"("linear")"});
      });
  method_tables(visit, a_case);
  const auto& periodic = a_case.periodic.axis;
  visit.optional_table("periodic",
                       "Periodic cell. Leave the table out if no direction is periodic.",
                       periodic[0] || periodic[1] || periodic[2],
                       [&](auto& keys) { periodic_keys(keys, a_case.periodic); });
  visit.materials("material", "Material, to which bodies refer by NAME.");
  visit.list("body", "Elastic body. Its surface is free except where a boundary acts on it.",
             a_case.bodies, [](auto& keys, BodyCase& body) { body_keys(keys, body); });
  visit.list("boundary", "Wall, or load on a part of the free surface.", a_case.boundaries,
             [](auto& keys, BoundaryCase& boundary) { boundary_keys(keys, boundary); });
  visit.list(
      "contact", "Contact between two bodies. Bodies without a contact pass through each other.",
      a_case.contacts, [](auto& keys, ContactCase& contact) { contact_keys(keys, contact); });
  visit.list("cut", "Blade that cuts a body (point_based only).", a_case.cuts,
             [](auto& keys, CutCase& cut) { cut_keys(keys, cut); });
  visit.table("output", "Output files and intervals.",
              [&](auto& keys) { output_keys(keys, a_case.output); });
  visit.table("checks", "Response to violated conservation laws, see checks in the user guide.",
              [&](auto& keys) { check_keys(keys, a_case.checks); });
  visit.list("measurement",
             "Quantity with its final value in `summary.json` and its history in `result.h5`.",
             a_case.measurements,
             [](auto& keys, MeasurementCase& m) { measurement_keys(keys, m); });
}

}  // namespace pliant

#pragma once

#include "engine/case/body_keys.hpp"
#include "engine/case/key.hpp"
#include "engine/case/measurement_keys.hpp"
#include "engine/case/words.hpp"

/// The vocabulary of case files: every key with its place in `Case`, unit, limits and meaning,
/// stated once. Three visitors walk it: one reads and checks a file, one writes
/// `case.resolved.toml`, one writes the reference. A visitor has
///
///     bool visit(key, value, notes)         false: the value is not usable
///     void visit.table(key, meaning, keys)            [key]
///     void visit.optional_table(key, meaning, present, keys)
///     void visit.list(key, meaning, elements, keys)   [[key]]
///     void visit.materials(key, meaning)              [key.NAME]
///     int visit.dimension()
namespace pliant {

template <class Visitor>
void remeshing_keys(Visitor& visit, decltype(Case::remeshing)& remeshing) {
  visit("every", RemeshRule{remeshing},
        {.meaning = R"(time steps between remeshings, "adaptive" (RP.28) or "never")",
         .unit = "steps",
         .example = "10",
         .limits = at_least_one});
  visit("strain", remeshing.strain,
        {.meaning = R"("adaptive": remesh when the strain since the last remeshing exceeds this)",
         .example = "0.2",
         .limits = {0, 1, false, true, "above 0 and at most 1"}});
  visit("filter", remeshing.filter,
        {.meaning = "strength of the high-order filter (RP.27); 0 switches it off",
         .example = "0.2",
         .limits = {0, 1, true, true, "from 0 to 1"}});
  VolumeRule volume = remeshing.extensive ? VolumeRule::extensive : VolumeRule::reset;
  visit("volume", volume, {.meaning = "what particles weigh afterwards", .example = R"("reset")"});
  remeshing.extensive = volume == VolumeRule::extensive;
}

template <class Visitor>
void periodic_keys(Visitor& visit, decltype(Case::periodic)& periodic) {
  visit("axes", AxisSet{periodic.axis},
        {.meaning = "directions in which the domain repeats",
         .example = R"(["x", "y"])",
         .required = true});
  visit("lower", periodic.lower,
        {.meaning = "lower corner of the cell; other directions do not matter",
         .unit = "m",
         .example = "[0, 0]",
         .limits = finite_or_infinite,
         .required = true});
  visit("upper", periodic.upper,
        {.meaning = "upper corner; the cell holds a whole number of spacings",
         .unit = "m",
         .example = "[1, 1]",
         .limits = finite_or_infinite,
         .required = true});
}

template <class Visitor>
void output_keys(Visitor& visit, decltype(Case::output)& output) {
  visit("every", output.every,
        {.meaning = "time between frames; 0: the first and the last only",
         .unit = "s",
         .example = "0.001",
         .limits = not_negative});
  visit("checkpoint_every", output.checkpoint_every,
        {.meaning = "time between checkpoints; 0: only when interrupted",
         .unit = "s",
         .example = "0.01",
         .limits = not_negative});
  visit("ghosts", output.ghosts,
        {.meaning = "whether frames hold ghost particles too", .example = "false"});
  visit("surface", output.surface,
        {.meaning = "whether frames hold the free surface of every body as a mesh, for "
                    "surface.xdmf",
         .example = "false"});
  visit("measure_every", output.measure_every,
        {.meaning = "time between measurements; 0: at every remeshing and at the end",
         .unit = "s",
         .example = "0.001",
         .limits = not_negative});
}

template <class Visitor>
void time_keys(Visitor& visit, decltype(Case::time)& time) {
  visit("end", time.end,
        {.meaning = "time at which the run ends",
         .unit = "s",
         .example = "0.02",
         .limits = positive,
         .required = true});
  visit("step", StepRule{time.step},
        {.meaning = R"(time step, or "cfl": from the wave speed (RP.20))",
         .unit = "s",
         .example = "5e-5",
         .limits = positive});
  visit("cfl", time.cfl,
        {.meaning = R"(CFL number of step = "cfl")",
         .example = "0.5",
         .limits = {0, 2, false, true, "above 0 and at most 2"}});
}

template <class Visitor>
void discretisation_keys(Visitor& visit, decltype(Case::discretisation)& discretisation,
                         Method method) {
  visit("spacing", discretisation.spacing,
        {.meaning = "distance h between particles: the resolution",
         .unit = "m",
         .example = "0.03125",
         .limits = positive,
         .required = true});
  if (method != Method::remeshed) return;
  visit("weight", discretisation.weight,
        {.meaning = "pair weight of gradients", .example = R"("compact")"});
  visit(
      "dissipation", discretisation.dissipation,
      {.meaning = "damping of what the lattice does not resolve (RP.43); free surfaces need it in "
                  "long runs",
       .example = "0.5",
       .limits = {0, 2, true, true, "from 0 to 2"}});
  visit("operators", discretisation.operators,
        {.meaning = "how fields are differentiated", .example = R"("moment_matrix")"});
  visit("artificial_viscosity", discretisation.artificial_viscosity,
        {.meaning = "of \"symmetric_sph\": alpha of (RP.75)",
         .example = "1",
         .limits = not_negative});
  visit("artificial_stress", discretisation.artificial_stress,
        {.meaning = "of \"symmetric_sph\": epsilon of (RP.76), against the tensile instability; 0 "
                    "switches it off",
         .example = "0.3",
         .limits = not_negative});
}

template <class Visitor>
void total_lagrangian_keys(Visitor& visit, decltype(Case::total_lagrangian)& method) {
  visit("hourglass", method.hourglass,
        {.meaning = "resistance to what stress points do not feel, over that of "
                    "shear (TL.6)",
         .example = "0.8",
         .limits = {0, 2, true, true, "from 0 to 2"}});
  visit("mass_scaling", MassScaling{method},
        {.meaning = R"(inertia over mass, or "to_step": what time.step needs to be stable)",
         .example = "1e4",
         .limits = at_least_one});
  visit("damping", Damping{method.damping},
        {.meaning = R"(rate at which motion fades (TL.8), or "adaptive": twice the frequency of )"
                    "what moves (TL.10)",
         .unit = "1/s",
         .example = "0.5",
         .limits = not_negative});
}

template <class Visitor>
void case_keys(Visitor& visit, Case& a_case) {
  visit("title", a_case.title, {.meaning = "one line about the case", .example = R"("A case")"});
  visit("name", Name{a_case.name},
        {.meaning = "of the results; by default that of the file, or of the folder of a case.toml",
         .example = R"("compression")"});
  visit("dimension", a_case.dimension,
        {.meaning = "2 (plane strain) or 3; vectors have as many components",
         .example = "2",
         .limits = {2, 3, true, true, "2 or 3"}});
  visit("method", a_case.method, {.meaning = "numerical method", .example = R"("remeshed")"});
  visit.table("discretisation", "Resolution.",
              [&](auto& keys) { discretisation_keys(keys, a_case.discretisation, a_case.method); });
  visit.table("time", "Simulated time.", [&](auto& keys) { time_keys(keys, a_case.time); });
  const bool remeshed = a_case.method == Method::remeshed;
  visit.optional_table("remeshing", "When and how particles return to their lattice.", remeshed,
                       [&](auto& keys) { remeshing_keys(keys, a_case.remeshing); });
  visit.optional_table(
      "level_set", "The level set that carries the free surface.", remeshed, [&](auto& keys) {
        keys("reinitialise_every", a_case.level_set.reinitialise_every,
             {.meaning = "time steps between reinitialisations to a signed distance",
              .unit = "steps",
              .example = "20",
              .limits = at_least_one});
      });
  visit.optional_table("ghosts", "Particles outside the body that hold its boundary conditions.",
                       remeshed, [&](auto& keys) {
                         keys("treatment", a_case.ghosts,
                              {.meaning = "how their values are found", .example = R"("linear")"});
                       });
  visit.optional_table("total_lagrangian",
                       "What method total_lagrangian does, and how slow its loads are.", !remeshed,
                       [&](auto& keys) { total_lagrangian_keys(keys, a_case.total_lagrangian); });
  const auto& periodic = a_case.periodic.axis;
  visit.optional_table("periodic", "A cell that repeats; leave the table out where nothing does.",
                       periodic[0] || periodic[1] || periodic[2],
                       [&](auto& keys) { periodic_keys(keys, a_case.periodic); });
  visit.materials("material", "A named material, for bodies to refer to.");
  visit.list("body", "An elastic body. Its surface is free where no boundary says otherwise.",
             a_case.bodies, [](auto& keys, BodyCase& body) { body_keys(keys, body); });
  visit.list("boundary", "A wall, or a pressure on a part of the free surface.", a_case.boundaries,
             [](auto& keys, BoundaryCase& boundary) { boundary_keys(keys, boundary); });
  visit.list(
      "contact", "Two bodies that feel each other; without it bodies pass through each other.",
      a_case.contacts, [](auto& keys, ContactCase& contact) { contact_keys(keys, contact); });
  visit.table("output", "What is written, and how often.",
              [&](auto& keys) { output_keys(keys, a_case.output); });
  visit.list("measurement",
             "A number that `summary.json` gives at the end, with its history in `result.h5`.",
             a_case.measurements,
             [](auto& keys, MeasurementCase& m) { measurement_keys(keys, m); });
}

}  // namespace pliant

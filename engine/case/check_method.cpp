#include <fmt/format.h>

#include "engine/case/check.hpp"

// What a case asks for that its method, or its operators, cannot do.
namespace pliant {

namespace {

// Plain SPH has neither ghosts nor a level set that its particles would come back to.
void check_operators(const Check& check) {
  const Case& a_case = check.a_case;
  if (a_case.discretisation.operators != Operators::symmetric_sph) return;
  if (a_case.remeshing.policy != decltype(Case::remeshing)::Policy::never) {
    check.problems.add(check.place("discretisation", "operators"), "symmetric_sph does not remesh",
                       "write every = \"never\" in [remeshing]");
  }
  if (!a_case.boundaries.empty()) {
    check.problems.add(check.place("discretisation", "operators"),
                       "symmetric_sph knows free surfaces and periods only",
                       "take the boundaries out, or operators = \"moment_matrix\"");
  }
  using Kind = MeasurementCase::Kind;
  for (std::size_t i = 0; i < a_case.measurements.size(); ++i) {
    const Kind kind = a_case.measurements[i].kind;
    if (kind != Kind::extent && kind != Kind::surface_distance && kind != Kind::mean_radius &&
        kind != Kind::surface_area) {
      continue;
    }
    check.problems.add(check.place("measurement", i, "kind"),
                       fmt::format("measurement \"{}\" needs a level set, which symmetric_sph does "
                                   "not follow",
                                   a_case.measurements[i].name),
                       "take it out, or measure points and conserved quantities");
  }
  if (a_case.output.surface) {
    check.problems.add(check.place("output", "surface"),
                       "surfaces need a level set, which symmetric_sph does not follow",
                       "write surface = false");
  }
}

void refuse_tables(const Check& check, std::initializer_list<std::string_view> tables) {
  for (const std::string_view table : tables) {
    if (!check.root.contains(table)) continue;
    check.problems.add(
        check.place(table, ""),
        fmt::format("method \"{}\" has no [{}]",
                    words<Method>[static_cast<int>(check.a_case.method)].text, table),
        "leave the table out, or choose another method");
  }
}

bool measures_undeformed_bodies(MeasurementCase::Kind kind) {
  using Kind = MeasurementCase::Kind;
  switch (kind) {
    case Kind::surface_distance:
    case Kind::mean_radius:
    case Kind::point_value:
    case Kind::wall_force:
    case Kind::contact_force:
    case Kind::velocity_error:
    case Kind::minimum_particle_distance:
      return false;
    default:
      return true;
  }
}

void check_undeformed_body(const Check& check, std::size_t i) {
  const BodyCase& body = check.a_case.bodies[i];
  if (body.material_as_given.model != MaterialCase::Model::reduced_polynomial) {
    check.problems.add(check.place("body", i, "material"),
                       fmt::format("body \"{}\" is not hyperelastic", body.name),
                       "method total_lagrangian takes model = \"reduced_polynomial\"");
  } else if (!body.material_as_given.prony.ratios.empty()) {
    check.problems.add(check.place("body", i, "material"),
                       fmt::format("body \"{}\" relaxes in time", body.name),
                       "method total_lagrangian takes materials without prony");
  }
  if (body.stretch != Vector{1, 1, 1}) {
    check.problems.add(
        check.place("body", i, "stretch"), fmt::format("body \"{}\" starts stretched", body.name),
        "method total_lagrangian starts from rest: let walls or pressure stretch it");
  }
}

void check_total_lagrangian(const Check& check) {
  const Case& a_case = check.a_case;
  refuse_tables(check, {"remeshing", "level_set", "ghosts", "periodic", "contact"});
  for (std::size_t i = 0; i < a_case.bodies.size(); ++i) check_undeformed_body(check, i);
  for (std::size_t i = 0; i < a_case.boundaries.size(); ++i) {
    if (a_case.boundaries[i].kind != BoundaryCase::Kind::contact_wall) continue;
    check.problems.add(check.place("boundary", i, "kind"),
                       "method total_lagrangian knows no contact",
                       "take method = \"remeshed\", or a wall that holds what it touches");
  }
  for (std::size_t i = 0; i < a_case.measurements.size(); ++i) {
    if (measures_undeformed_bodies(a_case.measurements[i].kind)) continue;
    check.problems.add(
        check.place("measurement", i, "kind"),
        fmt::format(
            "method total_lagrangian does not measure a {}",
            words<MeasurementCase::Kind>[static_cast<int>(a_case.measurements[i].kind)].text),
        "measure extent, point_displacement, volume, surface_area, momenta or energies");
  }
  if (a_case.total_lagrangian.match_time_step && !a_case.time.step) {
    check.problems.add(check.place("total_lagrangian", "mass_scaling"),
                       "the mass can only be scaled to a given time step",
                       "give time.step in seconds, or mass_scaling as a number");
  }
}

}  // namespace

void check_method(const Check& check) {
  if (check.a_case.method == Method::total_lagrangian) {
    check_total_lagrangian(check);
  } else {
    refuse_tables(check, {"total_lagrangian"});
  }
  check_operators(check);
}

}  // namespace pliant

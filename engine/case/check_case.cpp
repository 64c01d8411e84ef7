#include "engine/case/check_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/case/check.hpp"
#include "engine/case/words.hpp"
#include "engine/geometry/signed_distance.hpp"

namespace pliant {

bool is_whole(const Shape& shape, int dimension) {
  switch (shape.kind) {
    case Shape::Kind::box:
      for (int i = 0; i < dimension; ++i) {
        if (!(shape.lower[i] < shape.upper[i])) return false;
      }
      return true;
    case Shape::Kind::ball:
    case Shape::Kind::cylinder:
      return shape.radius > 0;
    case Shape::Kind::half_space:
      return shape.normal != Vector{};
    case Shape::Kind::mesh:
      return shape.mesh != nullptr;
    default:
      return !shape.operands.empty() &&
             std::all_of(shape.operands.begin(), shape.operands.end(),
                         [dimension](const Shape& part) { return is_whole(part, dimension); });
  }
}

namespace {

std::string_view axis_name(int axis) { return words<Axis>[axis].text; }

template <class Element>
void check_names(const Check& check, std::string_view list, const std::vector<Element>& elements) {
  std::set<std::string_view> taken;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (taken.insert(elements[i].name).second || elements[i].name.empty()) continue;
    check.problems.add(check.place(list, i, "name"),
                       fmt::format("two [[{}]] tables are called \"{}\"", list, elements[i].name),
                       "give each its own name");
  }
}

void check_extent(const Check& check, std::size_t index, int axis, const Box& box) {
  const Case& a_case = check.a_case;
  const std::string& name = a_case.bodies[index].name;
  const Place place = check.place("body", index, "geometry");
  const double extent = box.upper[axis] - box.lower[axis];
  const double spacing = a_case.discretisation.spacing;
  if (extent <= 0) {
    check.problems.add(place, fmt::format("body \"{}\" holds no point", name),
                       "let the parts of its geometry overlap");
  } else if (a_case.periodic.axis[axis]) {
    const bool fits = std::isinf(extent) || (box.lower[axis] >= a_case.periodic.lower[axis] &&
                                             box.upper[axis] <= a_case.periodic.upper[axis]);
    if (fits) return;
    check.problems.add(
        place,
        fmt::format("body \"{}\" reaches beyond the periodic cell along {}", name, axis_name(axis)),
        "end it at the cell's corners, or give it infinite ends");
  } else if (std::isinf(extent)) {
    check.problems.add(place, fmt::format("body \"{}\" has no end along {}", name, axis_name(axis)),
                       "give finite corners, or intersect it with a box");
  } else if (spacing > extent) {
    check.problems.add(
        check.place("discretisation", "spacing"),
        fmt::format("spacing {} is larger than body \"{}\", which is {} wide along {}", spacing,
                    name, extent, axis_name(axis)),
        fmt::format("take {} for ten particles across it", extent / 10));
  }
}

void check_bodies(const Check& check) {
  const Case& a_case = check.a_case;
  const toml::node* bodies = check.root.get("body");
  if (!bodies || (bodies->is_array() && bodies->as_array()->empty())) {
    check.problems.add(check.start, "the case has no body",
                       "add [[body]] with name, geometry and material");
  }
  for (std::size_t i = 0; i < a_case.bodies.size(); ++i) {
    const toml::table& table = *check.root["body"][i].as_table();
    if (table.contains("velocity") && table.contains("rotation")) {
      check.problems.add(
          check.place("body", i, "rotation"),
          fmt::format("body \"{}\" has both velocity and rotation", a_case.bodies[i].name),
          "keep one of them");
    }
    if (a_case.bodies[i].stretch != Vector{1, 1, 1} &&
        a_case.bodies[i].material_as_given.model == MaterialCase::Model::linear) {
      check.problems.add(
          check.place("body", i, "stretch"),
          fmt::format("body \"{}\" is stretched, but its material follows rates and knows no shape "
                      "at rest",
                      a_case.bodies[i].name),
          "give it a material of model = \"reduced_polynomial\"");
    }
    if (!is_whole(a_case.bodies[i].geometry, a_case.dimension)) continue;
    const Box box = bounding_box(a_case.bodies[i].geometry);
    const std::size_t before = check.problems.count();
    for (int axis = 0; axis < a_case.dimension && check.problems.count() == before; ++axis) {
      check_extent(check, i, axis, box);
    }
  }
}

void check_periodic_cell(const Check& check) {
  const auto& periodic = check.a_case.periodic;
  const double spacing = check.a_case.discretisation.spacing;
  for (int axis = 0; axis < check.a_case.dimension; ++axis) {
    const double period = periodic.upper[axis] - periodic.lower[axis];
    const double cells = period / spacing;
    if (!periodic.axis[axis] || periodic.lower == periodic.upper) continue;
    if (!(period > 0) || std::isinf(period)) {
      check.problems.add(check.place("periodic", "upper"),
                         fmt::format("the periodic cell goes from {} to {} along {}",
                                     periodic.lower[axis], periodic.upper[axis], axis_name(axis)),
                         "give finite corners, lower below upper");
    } else if (spacing > 0 && std::abs(cells - std::round(cells)) > 1e-6) {
      check.problems.add(
          check.place("discretisation", "spacing"),
          fmt::format("the period {} along {} is not a multiple of the spacing {}", period,
                      axis_name(axis), spacing),
          fmt::format("take spacing = {}", period / std::max(1.0, std::round(cells))));
    }
  }
}

void check_times(const Check& check) {
  const auto& time = check.a_case.time;
  if (time.step && time.end > 0 && *time.step > time.end) {
    check.problems.add(
        check.place("time", "step"),
        fmt::format("step {} is longer than the run, which ends at {}", *time.step, time.end),
        "take a smaller step, or \"cfl\"");
  }
}

// Between remeshings a ghost stays on the side of a wall on which it started, and only particles
// that strain make the adaptive rule remesh: a body that flies towards a wall would pass it.
void check_contact_walls(const Check& check) {
  const auto& boundaries = check.a_case.boundaries;
  bool any = false;
  for (std::size_t i = 0; i < boundaries.size(); ++i) {
    if (boundaries[i].kind != BoundaryCase::Kind::contact_wall) continue;
    any = true;
    if (boundaries[i].geometry.kind == Shape::Kind::half_space ||
        !is_whole(boundaries[i].geometry, check.a_case.dimension)) {
      continue;
    }
    check.problems.add(check.place("boundary", i, "geometry"),
                       fmt::format("contact wall \"{}\" is no half_space", boundaries[i].name),
                       "give a half_space; bodies touch plane walls only");
  }
  if (any && check.a_case.method == Method::remeshed &&
      check.a_case.remeshing.policy != decltype(Case::remeshing)::Policy::every) {
    check.problems.add(check.place("remeshing", "every"),
                       "contact walls need a fixed number of steps between remeshings",
                       "write every = 10 in [remeshing]");
  }
}

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
    if (kind != Kind::extent && kind != Kind::ray && kind != Kind::mean_radius &&
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

void check_measurements(const Check& check) {
  const auto& measurements = check.a_case.measurements;
  for (std::size_t i = 0; i < measurements.size(); ++i) {
    if (measurements[i].kind == MeasurementCase::Kind::wall_force &&
        measurements[i].boundary >= 0) {
      const std::size_t boundary = static_cast<std::size_t>(measurements[i].boundary);
      const auto& boundaries = check.a_case.boundaries;
      if (boundary < boundaries.size() &&
          boundaries[boundary].kind != BoundaryCase::Kind::contact_wall) {
        check.problems.add(check.place("measurement", i, "boundary"),
                           fmt::format("boundary \"{}\" is no contact wall, whose force is known",
                                       boundaries[boundary].name),
                           "name a boundary of kind contact_wall");
      }
    }
    if (measurements[i].of < 0) continue;
    const MeasurementCase& source = measurements[measurements[i].of];
    if (source.of < 0) continue;
    check.problems.add(
        check.place("measurement", i, "of"),
        fmt::format(R"(measurement "{}" reads "{}", which has no history of its own)",
                    measurements[i].name, source.name),
        "name a measurement that reads no other");
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
    case Kind::ray:
    case Kind::mean_radius:
    case Kind::point_value:
    case Kind::wall_force:
    case Kind::contact_force:
    case Kind::velocity_error:
    case Kind::closest_pair:
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
  if (a_case.total_lagrangian.scale_to_step && !a_case.time.step) {
    check.problems.add(check.place("total_lagrangian", "mass_scaling"),
                       "the mass can only be scaled to a given time step",
                       "give time.step in seconds, or mass_scaling as a number");
  }
}

void check_method(const Check& check) {
  if (check.a_case.method == Method::total_lagrangian) return check_total_lagrangian(check);
  refuse_tables(check, {"total_lagrangian"});
}

}  // namespace

void check_case(const Case& a_case, const toml::table& root, const Place& start,
                Problems& problems) {
  const Check check{a_case, root, start, problems};
  check_names(check, "body", a_case.bodies);
  check_names(check, "boundary", a_case.boundaries);
  check_names(check, "measurement", a_case.measurements);
  check_method(check);
  check_bodies(check);
  check_periodic_cell(check);
  check_times(check);
  check_contact_walls(check);
  check_operators(check);
  check_contacts(check);
  check_measurements(check);
}

}  // namespace pliant

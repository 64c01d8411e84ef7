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
  if (any && check.a_case.remeshing.policy != decltype(Case::remeshing)::Policy::every) {
    check.problems.add(check.place("remeshing", "every"),
                       "contact walls need a fixed number of steps between remeshings",
                       "write every = 10 in [remeshing]");
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
        "name a measurement that is no period or amplitude_ratio");
  }
}

}  // namespace

void check_case(const Case& a_case, const toml::table& root, const Place& start,
                Problems& problems) {
  const Check check{a_case, root, start, problems};
  check_names(check, "body", a_case.bodies);
  check_names(check, "boundary", a_case.boundaries);
  check_names(check, "measurement", a_case.measurements);
  check_bodies(check);
  check_periodic_cell(check);
  check_times(check);
  check_contact_walls(check);
  check_contacts(check);
  check_measurements(check);
}

}  // namespace pliant

#include <fmt/format.h>

#include <algorithm>

#include "engine/case/check.hpp"
#include "engine/geometry/signed_distance.hpp"

namespace pliant {
namespace {

using Kind = MeasurementCase::Kind;

/// Whether a [[contact]] joins two bodies, in either order.
bool have_contact(const Case& a_case, std::array<int, 2> bodies) {
  return std::any_of(a_case.contacts.begin(), a_case.contacts.end(), [&](const ContactCase& c) {
    return std::is_permutation(bodies.begin(), bodies.end(), c.bodies.begin());
  });
}

void check_contact_force(const Check& check, std::size_t i) {
  const Case& a_case = check.a_case;
  const MeasurementCase& m = a_case.measurements[i];
  if (m.bodies[0] < 0 || m.bodies[1] < 0 || have_contact(a_case, m.bodies)) return;
  check.problems.add(
      check.place("measurement", i, "bodies"),
      fmt::format("bodies \"{}\" and \"{}\" have no [[contact]], so that they exert no force",
                  a_case.bodies[m.bodies[0]].name, a_case.bodies[m.bodies[1]].name),
      "add a [[contact]] between them, or name two bodies that have one");
}

void check_wall_force(const Check& check, std::size_t i) {
  const auto& boundaries = check.a_case.boundaries;
  const auto boundary = static_cast<std::size_t>(check.a_case.measurements[i].boundary);
  if (boundary >= boundaries.size() ||
      boundaries[boundary].kind == BoundaryCase::Kind::contact_wall) {
    return;
  }
  check.problems.add(
      check.place("measurement", i, "boundary"),
      fmt::format("boundary \"{}\" is not a contact wall, so that its force is not known",
                  boundaries[boundary].name),
      "name a boundary of kind contact_wall");
}

void check_source(const Check& check, std::size_t i) {
  const auto& measurements = check.a_case.measurements;
  if (measurements[i].of < 0) return;
  const MeasurementCase& source = measurements[measurements[i].of];
  if (row_of(source.kind).sampling != Sampling::from_history) return;
  check.problems.add(
      check.place("measurement", i, "of"),
      fmt::format(R"(measurement "{}" evaluates "{}", which itself evaluates another measurement)",
                  measurements[i].name, source.name),
      "name a measurement that does not evaluate another one");
}

/// Half a spacing is what a lattice may leave between its outermost particle and the surface.
void check_material_point(const Check& check, std::size_t i) {
  const Case& a_case = check.a_case;
  const MeasurementCase& m = a_case.measurements[i];
  const auto body = static_cast<std::size_t>(m.body);
  if (body >= a_case.bodies.size() || !is_whole(a_case.bodies[body].geometry, a_case.dimension)) {
    return;
  }
  const double distance = signed_distance(a_case.bodies[body].geometry, m.point, a_case.dimension);
  if (distance <= 0.5 * a_case.discretisation.spacing) return;
  check.problems.add(
      check.place("measurement", i, "point"),
      fmt::format("the point of measurement \"{}\" lies {:.3g} m outside body \"{}\" at t = 0",
                  m.name, distance, a_case.bodies[body].name),
      "give a point inside the body or on its surface");
}

}  // namespace

void check_measurements(const Check& check) {
  for (std::size_t i = 0; i < check.a_case.measurements.size(); ++i) {
    check_source(check, i);
    const Kind kind = check.a_case.measurements[i].kind;
    if (kind == Kind::wall_force) check_wall_force(check, i);
    if (kind == Kind::contact_force) check_contact_force(check, i);
    if (kind == Kind::point_displacement) check_material_point(check, i);
  }
}

}  // namespace pliant

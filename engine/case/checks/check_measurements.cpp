#include <fmt/format.h>

#include "engine/case/checks/check.hpp"
#include "engine/case/placement.hpp"
#include "engine/geometry/signed_distance.hpp"

namespace pliant {
namespace {

using Kind = MeasurementCase::Kind;

void check_contact_force(const Check& check, std::size_t i) {
  const Case& a_case = check.a_case;
  const MeasurementCase& m = a_case.measurements[i];
  if (m.bodies[0] < 0 || m.bodies[1] < 0) return;
  if (m.bodies[0] == m.bodies[1]) {
    check.problems.add(check.place("measurement", i, "bodies"), "bodies names the same body twice",
                       "name two different bodies");
    return;
  }
  if (have_contact(a_case, m.bodies)) return;
  check.problems.add(
      check.place("measurement", i, "bodies"),
      fmt::format("bodies \"{}\" and \"{}\" have no [[contact]], so that they exert no force",
                  a_case.bodies[m.bodies[0]].name, a_case.bodies[m.bodies[1]].name),
      "add a [[contact]] between them, or name two bodies that have one");
}

void check_wall_force(const Check& check, std::size_t i) {
  const auto& boundaries = check.a_case.boundaries;
  const auto boundary = static_cast<std::size_t>(check.a_case.measurements[i].boundary);
  if (boundary >= boundaries.size() || row_of(boundaries[boundary].kind).is_wall) {
    return;
  }
  check.problems.add(
      check.place("measurement", i, "boundary"),
      fmt::format(
          "boundary \"{}\" is not a wall, so that its force is the load that the case gives",
          boundaries[boundary].name),
      "name a wall");
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

void check_terms(const Check& check, std::size_t i) {
  const Case& a_case = check.a_case;
  const MeasurementCase& m = a_case.measurements[i];
  if (!m.factors.empty() && m.factors.size() != m.terms.size()) {
    check.problems.add(check.place("measurement", i, "factors"),
                       fmt::format("measurement \"{}\" has {} terms and {} factors", m.name,
                                   m.terms.size(), m.factors.size()),
                       "give one factor for each term");
  }
  for (const int term : m.terms) {
    const MeasurementCase& source = a_case.measurements[term];
    if (row_of(source.kind).sampling == Sampling::from_history) {
      check.problems.add(
          check.place("measurement", i, "terms"),
          fmt::format(R"(measurement "{}" adds "{}", which itself evaluates another measurement)",
                      m.name, source.name),
          "name measurements that do not evaluate another one");
    } else if (unit_of(a_case, source) != unit_of(a_case, a_case.measurements[m.terms.front()])) {
      check.problems.add(check.place("measurement", i, "terms"),
                         fmt::format("measurement \"{}\" adds different units, {} and {}", m.name,
                                     unit_of(a_case, a_case.measurements[m.terms.front()]),
                                     unit_of(a_case, source)),
                         "name measurements of one unit");
    }
  }
}

void check_time(const Check& check, std::size_t i) {
  const MeasurementCase& m = check.a_case.measurements[i];
  if (m.time <= check.a_case.time.end) return;
  check.problems.add(
      check.place("measurement", i, "time"),
      fmt::format("measurement \"{}\" is of t = {}, after the end of the run", m.name, m.time),
      "give a time up to time.end");
}

/// A lattice may leave half a spacing between its outermost particle and the surface.
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
    if (kind == Kind::wall_force || kind == Kind::wall_moment) check_wall_force(check, i);
    if (kind == Kind::contact_force) check_contact_force(check, i);
    if (kind == Kind::weighted_sum) check_terms(check, i);
    if (kind == Kind::value_at_time) check_time(check, i);
    if (kind == Kind::point_displacement || kind == Kind::material_value)
      check_material_point(check, i);
  }
}

}  // namespace pliant

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/case/checks/check_motion.hpp"

namespace pliant {

namespace {

template <class Element>
void check_names(const Check& check, std::string_view list, const std::vector<Element>& elements) {
  std::set<std::string_view> taken;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (taken.insert(elements[i].name).second || elements[i].name.empty()) continue;
    check.problems.add(
        check.place(list, i, "name"),
        fmt::format("two [[{}]] tables have the name \"{}\"", list, elements[i].name),
        "give each a different name");
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
          fmt::format("use spacing = {}", period / std::max(1.0, std::round(cells))));
    }
  }
}

void check_times(const Check& check) {
  const auto& time = check.a_case.time;
  if (time.step && time.end > 0 && *time.step > time.end) {
    check.problems.add(
        check.place("time", "step"),
        fmt::format("step {} is longer than the run, which ends at {}", *time.step, time.end),
        "use a smaller step, or \"cfl\"");
  }
}

void check_wall_displacement(const Check& check, std::size_t i) {
  const BoundaryCase& wall = check.a_case.boundaries[i];
  if (!wall.displacement) return;
  check_start_of_motion(check, check.place("boundary", i, "displacement"),
                        fmt::format("the displacement of wall \"{}\"", wall.name),
                        *wall.displacement, 0);
}

// An angle that jumps at the start would tear the body from the wall.
void check_wall_rotation(const Check& check, std::size_t i) {
  constexpr double rounding = 1e-9;
  const BoundaryCase& wall = check.a_case.boundaries[i];
  if (!wall.rotation) return;
  const Place place = check.place("boundary", i, "rotation");
  const Expression& angle = wall.rotation->angle;
  try {
    const double turned = angle(0);
    if (std::abs(turned) <= rounding) return;
    check.problems.add(
        place, fmt::format("the angle of wall \"{}\" is {:.4g} at t = 0", wall.name, turned),
        fmt::format("write angle = \"{} - ({:.6g})\"", angle.text(), turned));
  } catch (const RunError&) {
    check.problems.add(
        place, fmt::format("the angle of wall \"{}\" has no finite value at t = 0", wall.name),
        "give a formula that is zero there");
  }
}

void check_wall_motion(const Check& check) {
  const auto& boundaries = check.a_case.boundaries;
  for (std::size_t i = 0; i < boundaries.size(); ++i) {
    const toml::table& table = *check.root["boundary"][i].as_table();
    const bool has_velocity = table.contains("velocity");
    const bool has_displacement = table.contains("displacement");
    const bool has_rotation = table.contains("rotation");
    // A resolved case contains the default velocity; it does not count as a second motion.
    const bool rests = std::ranges::all_of(
        boundaries[i].velocity, [](const Expression& u) { return u.is_constant() && u(0) == 0; });
    if (has_velocity && has_displacement && !rests) {
      check.problems.add(
          check.place("boundary", i, "displacement"),
          fmt::format("wall \"{}\" has both velocity and displacement", boundaries[i].name),
          "keep one of them");
    } else if (row_of(boundaries[i].kind).motion == Use::required && !has_velocity &&
               !has_displacement && !has_rotation) {
      check.problems.add(
          check.place("boundary", i, "kind"),
          fmt::format("wall \"{}\" has no motion", boundaries[i].name),
          "give its velocity, as in velocity = [0, -25], its displacement, or its rotation");
    }
    check_wall_displacement(check, i);
    check_wall_rotation(check, i);
  }
}

}  // namespace

void check_start_of_motion(const Check& check, const Place& place, std::string_view subject,
                           const VectorExpression& displacement, double time) {
  constexpr double rounding = 1e-6;  // relative to the spacing
  for (int axis = 0; axis < check.a_case.dimension; ++axis) {
    const Expression& component = displacement[axis];
    try {
      const double moved = component(time);
      if (std::abs(moved) <= rounding * check.a_case.discretisation.spacing) continue;
      check.problems.add(place,
                         fmt::format("{} is {:.4g} along {} at t = {}, when it starts", subject,
                                     moved, axis_name(axis), time),
                         fmt::format("write \"{} - ({:.6g})\", or start from another place",
                                     component.text(), moved));
    } catch (const RunError&) {
      check.problems.add(place,
                         fmt::format("{} has no finite value along {} at t = {}, when it starts",
                                     subject, axis_name(axis), time),
                         "give a formula that is zero there");
    }
    return;
  }
}

void check_case(const Check& check) {
  check_names(check, "body", check.a_case.bodies);
  check_names(check, "boundary", check.a_case.boundaries);
  check_names(check, "cut", check.a_case.cuts);
  check_names(check, "measurement", check.a_case.measurements);
  check_method(check);
  check_bodies(check);
  check_periodic_cell(check);
  check_times(check);
  check_wall_motion(check);
  check_contacts(check);
  check_measurements(check);
}

}  // namespace pliant

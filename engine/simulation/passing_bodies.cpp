#include "engine/simulation/passing_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "engine/blocks/box.hpp"
#include "engine/case/method_rules.hpp"
#include "engine/case/placement.hpp"
#include "engine/point_based/bonds/nearest_nodes.hpp"

namespace pliant {

namespace {

using Points = std::vector<Vector>;

/// Particles of two bodies that only touch are farther apart than this, except on lattices whose
/// nodes lie on the surface, [spacings]; so are those of two parts of a body.
constexpr double inside = 0.6;

double distance_between(const Vector& x, const Vector& y) {
  return std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
}

Box<3> box_of(const Points& points) {
  Box<3> box;
  for (const Vector& x : points) box.grow(x);
  return box;
}

Points points_in(const Box<3>& box, const Points& points) {
  Points found;
  std::ranges::copy_if(points, std::back_inserter(found), [&](const Vector& x) {
    for (int a = 0; a < 3; ++a) {
      if (x[a] < box.lower[a] || x[a] > box.upper[a]) return false;
    }
    return true;
  });
  return found;
}

bool are_inside_each_other(const Points& first, const Points& second, double spacing) {
  const Box<3> of_first = box_of(first), of_second = box_of(second);
  Box<3> common;
  for (int a = 0; a < 3; ++a) {
    common.lower[a] = std::max(of_first.lower[a], of_second.lower[a]);
    common.upper[a] = std::min(of_first.upper[a], of_second.upper[a]);
    if (common.lower[a] > common.upper[a]) return false;
  }
  const Points near_first = points_in(common, first), near_second = points_in(common, second);
  if (near_first.empty()) return false;
  const point_based::NearestNodes<3> nodes(near_first);
  return std::ranges::any_of(near_second, [&](const Vector& x) {
    return distance_between(x, near_first[nodes.nearest(x)]) < inside * spacing;
  });
}

/// Undeformed places of particles from their present ones.
Points start_of(const Solver& solver, int body, const Points& present) {
  const std::vector<FieldView> fields = solver.fields(body);
  const FieldView& displacement = *std::ranges::find(fields, "displacement", &FieldView::name);
  Points start = present;
  const auto take_back = [&](const auto& components) {
    std::size_t i = 0;
    for (const SlotRun& run : solver.particle_runs(body)) {
      for (std::int64_t slot = run.first; slot < run.last; ++slot, ++i) {
        for (std::size_t a = 0; a < components.size(); ++a) start[i][a] -= components[a][slot];
      }
    }
  };
  if (displacement.values.empty()) {
    take_back(displacement.single_values);
  } else {
    take_back(displacement.values);
  }
  return start;
}

/// A particle that has a nearest neighbour which was far away, so that it is inside another part of
/// the body; null if there is none. However much a body deforms, the nearest particle is one of the
/// next.
const Vector* particle_in_another_part(const Points& start, const Points& present) {
  constexpr double far = 4;  // ratio to the distance of the next particle at the start
  const point_based::NearestNodes<3> at_present(present);
  std::optional<point_based::NearestNodes<3>> at_start;  // few runs need it
  for (std::size_t i = 0; i < start.size(); ++i) {
    for (const auto& [distance, node] : at_present.nearest(present[i], 2)) {
      if (static_cast<std::size_t>(node) == i) continue;
      const double former = distance_between(start[i], start[node]);
      if (far * distance >= inside * former) continue;
      if (!at_start) at_start.emplace(start);
      const double next = at_start->nearest(start[i], 2).back().distance;
      if (distance < inside * next && former > far * next) return &present[i];
    }
  }
  return nullptr;
}

}  // namespace

std::string passing_bodies_warning(const Solver& solver) {
  const Case& settings = solver.settings();
  std::vector<Points> present;
  for (int b = 0; b < static_cast<int>(settings.bodies.size()); ++b) {
    present.push_back(solver.positions(b));
    for (int a = 0; a < b; ++a) {
      if (have_contact(settings, {a, b}) ||
          !are_inside_each_other(present[a], present[b], settings.discretisation.spacing)) {
        continue;
      }
      return fmt::format(
          "warning: t = {:.6g} s: bodies `{}` and `{}` pass through each other, since no "
          "[[contact]] names them both; add one",
          solver.clock().time, settings.bodies[a].name, settings.bodies[b].name);
    }
  }
  return {};
}

std::string passing_parts_warning(const Solver& solver) {
  const Case& settings = solver.settings();
  if (settings.rules == nullptr || !settings.rules->has_self_contact) return {};
  for (int b = 0; b < static_cast<int>(settings.bodies.size()); ++b) {
    if (have_contact(settings, {b, b})) continue;
    const Points present = solver.positions(b);
    const Vector* inside_body = particle_in_another_part(start_of(solver, b, present), present);
    if (inside_body == nullptr) continue;
    const auto& [x, y, z] = *inside_body;
    const std::string& name = settings.bodies[b].name;
    return fmt::format(
        "warning: t = {:.6g} s: parts of body `{}` pass through each other at ({:.4g}, {:.4g}, "
        "{:.4g}); add a [[contact]] with bodies = [\"{}\", \"{}\"]",
        solver.clock().time, name, x, y, z, name, name);
  }
  return {};
}

std::string passing_tool_warning(const Solver& solver) {
  const BoundaryCase* tool = solver.tool_inside();
  if (tool == nullptr) return {};
  return fmt::format(
      "warning: t = {:.6g} s: the contact wall `{}` has got between the particles of the surface "
      "of a body: its force is too small from now on; press in a stiff body with a [[contact]] "
      "instead",
      solver.clock().time, tool->name);
}

}  // namespace pliant

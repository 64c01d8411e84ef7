#include "engine/case/placement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "engine/case/blade_track.hpp"
#include "engine/case/vocabulary/boundary_kinds.hpp"
#include "engine/geometry/mesh_files/load_meshes.hpp"
#include "engine/geometry/overlap.hpp"

namespace pliant {

namespace {

/// Points of a lattice in a box.
struct Probes {
  Vector lower = {};
  std::array<std::int64_t, 3> count = {1, 1, 1};
  double step = 0;

  std::int64_t size() const { return count[0] * count[1] * count[2]; }
  Vector at(std::int64_t k) const {
    const std::array<std::int64_t, 3> cell = {k % count[0], k / count[0] % count[1],
                                              k / count[0] / count[1]};
    Vector x = lower;
    for (int i = 0; i < 3; ++i) x[i] += step * static_cast<double>(cell[i]);
    return x;
  }
  /// Largest distance of a point of the box from the nearest probe.
  double reach(int dimension) const { return step * std::sqrt(dimension) / 2; }
};

/// Probes about `spacing` apart, or farther if there would be too many.
Probes probes_of(const Box<3>& box, double spacing, int dimension) {
  constexpr std::int64_t most = 100000;
  Probes probes;
  for (probes.step = spacing;; probes.step *= 1.25) {
    double points = 1;
    for (int i = 0; i < dimension; ++i) {
      const double length = box.upper[i] - box.lower[i];
      // Infinite shapes are the same everywhere along their axis.
      const bool has_end = std::isfinite(length);
      const double along = has_end ? std::floor(length / probes.step) + 1 : 1;
      probes.lower[i] = has_end ? box.lower[i] : std::clamp(0., box.lower[i], box.upper[i]);
      probes.count[i] = static_cast<std::int64_t>(std::min(along, 1. * most));
      points *= along;
    }
    if (points <= most) return probes;
  }
}

/// Whether a part of `region` is in the body, or only on its surface.
bool reaches(const Shape& region, const Shape& body, bool surface_alone, const Case& a_case) {
  const int dimension = a_case.dimension;
  const double spacing = a_case.discretisation.spacing;
  const Box<3> first = bounding_box(region), second = bounding_box(body);
  Box<3> both = {};
  for (int i = 0; i < dimension; ++i) {
    both.lower[i] = std::max(first.lower[i], second.lower[i]) - spacing;
    both.upper[i] = std::min(first.upper[i], second.upper[i]) + spacing;
    if (both.lower[i] > both.upper[i]) return false;
  }
  const Probes probes = probes_of(both, spacing, dimension);
  const double reach = probes.reach(dimension);
  for (std::int64_t k = 0; k < probes.size(); ++k) {
    const Vector x = probes.at(k);
    if (signed_distance(region, x, dimension) > reach) continue;
    const double distance = signed_distance(body, x, dimension);
    if ((surface_alone ? std::abs(distance) : distance) <= reach) return true;
  }
  return false;
}

bool reaches_any_body(const Shape& region, bool surface_alone, const Case& a_case) {
  return std::ranges::any_of(a_case.bodies, [&](const BodyCase& body) {
    return reaches(region, body.geometry, surface_alone, a_case);
  });
}

/// Distance of a wall or a region from the surface of a body [m]; negative where they overlap.
double gap_between(const Shape& region, const Shape& body, const Case& a_case) {
  const double step =
      probes_of(bounding_box(body), a_case.discretisation.spacing, a_case.dimension).step;
  return -2 * overlap(region, body, step, a_case.dimension);
}

/// Distance of a wall or a region from the nearest body that it reaches [m].
double gap_before(const Shape& region, const Case& a_case) {
  double gap = std::numeric_limits<double>::infinity();
  for (const BodyCase& body : a_case.bodies) {
    if (!reaches(region, body.geometry, false, a_case)) continue;
    gap = std::min(gap, gap_between(region, body.geometry, a_case));
  }
  return gap;
}

/// Largest coordinate of the bodies [m].
double size_of_bodies(const Case& a_case) {
  double size = 0;
  const Box<3> box = box_of_bodies(a_case);
  for (int a = 0; a < a_case.dimension; ++a) {
    size = std::max({size, std::abs(box.lower[a]), std::abs(box.upper[a])});
  }
  return size;
}

/// Whether a region that a load acts in holds a part of the surface of a body.
bool holds_surface(const Shape& region, const Case& a_case) {
  constexpr double precise = 1e-5;   // [spacings]
  constexpr double rounding = 1e-6;  // of places on surfaces, as where loads act
  const double touching =
      std::max(precise * a_case.discretisation.spacing, rounding * size_of_bodies(a_case));
  return reaches_any_body(region, true, a_case) && gap_before(region, a_case) < touching;
}

/// Walls hold bodies up to half a spacing away. What happens beyond depends on the method.
void warn_of_gap(const BoundaryCase& wall, const Case& a_case, std::vector<std::string>& warnings) {
  constexpr double touching = 0.01;  // [spacings]
  const double gap = gap_before(wall.geometry, a_case), h = a_case.discretisation.spacing;
  if (gap < touching * h) return;
  warnings.push_back(
      fmt::format("the wall `{}` is {:.2g} spacings ({:.3g} m) away from the nearest body: walls "
                  "hold bodies up to half a spacing away, and perhaps not beyond; let them touch",
                  wall.name, gap / h, gap));
}

/// Deeper overlaps are refused.
void warn_of_overlap(const BoundaryCase& wall, const Case& a_case,
                     std::vector<std::string>& warnings) {
  constexpr double touching = 0.002;  // [spacings]
  const double h = a_case.discretisation.spacing;
  for (const BodyCase& body : a_case.bodies) {
    if (!reaches(wall.geometry, body.geometry, false, a_case)) continue;
    const double depth = -gap_between(wall.geometry, body.geometry, a_case);
    if (depth < touching * h) continue;
    warnings.push_back(fmt::format(
        "body `{}` overlaps the contact wall `{}` by {:.2g} spacings ({:.3g} m) at the start; the "
        "wall pushes it out at once, which creates energy; let them touch",
        body.name, wall.name, depth / h, depth));
  }
}

/// Whether the edge of a blade is ever inside its body. The surface does not count.
bool meets_body(const CutCase& cut, const Case& a_case) {
  constexpr int times = 1000;
  constexpr double most_points = 1000, on_surface = 1e-6;  // [spacings]
  const Shape& body = a_case.bodies[cut.body].geometry;
  const double spacing = a_case.discretisation.spacing;
  for (int i = 0; i <= times; ++i) {
    const BladeEdge edge = edge_of(cut, cut.start + i * (cut.end - cut.start) / times);
    Vector along = {};  // in 2D the edge is a point
    for (int a = 0; a < 3 && a_case.dimension == 3; ++a) along[a] = edge.to[a] - edge.from[a];
    const double length = std::hypot(along[0], along[1], along[2]);
    const int pieces = static_cast<int>(std::min(std::ceil(length / spacing), most_points));
    for (int j = 0; j <= pieces; ++j) {
      Vector x = edge.from;
      for (int a = 0; a < 3 && pieces > 0; ++a) x[a] += j * along[a] / pieces;
      if (signed_distance(body, x, a_case.dimension) < -on_surface * spacing) return true;
    }
  }
  return false;
}

/// Bodies with a face in common seem to hold each other.
void warn_of_bodies_that_touch(const Case& a_case, std::vector<std::string>& warnings) {
  constexpr double touching = 0.1;  // [spacings] between the surfaces
  const double spacing = a_case.discretisation.spacing;
  for (int b = 1; b < static_cast<int>(a_case.bodies.size()); ++b) {
    for (int a = 0; a < b; ++a) {
      const BodyCase &first = a_case.bodies[a], &second = a_case.bodies[b];
      if (have_contact(a_case, {a, b}) || overlap(first.geometry, second.geometry, spacing,
                                                  a_case.dimension) < -touching * spacing) {
        continue;
      }
      warnings.push_back(fmt::format(
          "bodies `{}` and `{}` touch at the start, and no [[contact]] names them both, so that "
          "they neither push nor hold each other; add one (kind = \"tied\" joins them)",
          first.name, second.name));
    }
  }
}

}  // namespace

void load_meshes(Case& a_case) {
  for (BodyCase& body : a_case.bodies) load_meshes(body.geometry);
  for (BoundaryCase& boundary : a_case.boundaries) load_meshes(boundary.geometry);
}

Box<3> box_of_bodies(const Case& a_case) {
  Box<3> all;
  for (const BodyCase& body : a_case.bodies) all.grow(bounding_box(body.geometry));
  return all;
}

bool has_boundary(const Case& a_case, BoundaryCase::Kind kind) {
  return std::ranges::any_of(
      a_case.boundaries, [kind](const BoundaryCase& boundary) { return boundary.kind == kind; });
}

bool has_no_slip_walls(const Case& a_case) {
  using enum BoundaryCase::Kind;
  return has_boundary(a_case, fixed) || has_boundary(a_case, moving_wall);
}

bool has_supported_ties(const Case& a_case) {
  return !a_case.boundaries.empty() &&
         std::ranges::any_of(a_case.contacts, [](const ContactCase& contact) {
           return contact.law == ContactLaw::tied;
         });
}

bool have_contact(const Case& a_case, std::array<int, 2> bodies) {
  return std::ranges::any_of(a_case.contacts, [&](const ContactCase& contact) {
    return std::ranges::is_permutation(bodies, contact.bodies);
  });
}

std::vector<std::string> placement_warnings(const Case& a_case) {
  std::vector<std::string> warnings;
  warn_of_bodies_that_touch(a_case, warnings);
  for (const BoundaryCase& boundary : a_case.boundaries) {
    const BoundaryKind& kind = row_of(boundary.kind);
    if (kind.is_attached && !reaches_any_body(boundary.geometry, false, a_case)) {
      warnings.push_back(fmt::format(
          "the wall `{}` touches no body at the start, so that it holds nothing; move it, or write "
          "kind = \"contact_wall\" for bodies that meet it later",
          boundary.name));
    } else if (kind.is_attached) {
      warn_of_gap(boundary, a_case, warnings);
    } else if (boundary.kind == BoundaryCase::Kind::contact_wall) {
      warn_of_overlap(boundary, a_case, warnings);
    } else if (!kind.is_wall && !holds_surface(boundary.geometry, a_case)) {
      warnings.push_back(fmt::format(
          "the region of `{}` holds no surface of a body at the start, so that it loads "
          "nothing; let its geometry reach across a surface",
          boundary.name));
    }
  }
  for (const CutCase& cut : a_case.cuts) {
    if (!moves_in_run(cut, a_case) || meets_body(cut, a_case)) continue;
    warnings.push_back(fmt::format(
        "the cut `{}` never meets body `{}`; its path is a displacement, from where the edge is at "
        "the start, in the undeformed body",
        cut.name, a_case.bodies[cut.body].name));
  }
  return warnings;
}

}  // namespace pliant

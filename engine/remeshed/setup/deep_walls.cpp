#include "engine/remeshed/setup/deep_walls.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "engine/case/placement.hpp"
#include "engine/case/vocabulary/boundary_kinds.hpp"
#include "engine/remeshed/setup/particle_kinds.hpp"

namespace pliant::remeshed {

namespace {

constexpr double enough = 2 * ghost_band;  // [h] so that nothing depends on the far side
constexpr double beside = 3;               // [h] so that no ghost is nearer to a side of the wall

double extent(const Vector& lower, const Vector& upper, int axis) {
  return upper[axis] - lower[axis];
}

/// A side of a box, which an axis crosses.
struct Side {
  int axis;
  bool upper;
};

/// The side of a wall that faces all bodies, which may reach into the wall there; none where bodies
/// are on both sides.
std::optional<Side> side_before_bodies(const Shape& wall, const Box<3>& bodies, int dimension) {
  std::optional<Side> side;
  double widest = -std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < dimension; ++axis) {
    const double reach =
        std::min(extent(wall.lower, wall.upper, axis), extent(bodies.lower, bodies.upper, axis));
    for (const bool upper : {false, true}) {
      const double gap =
          upper ? bodies.lower[axis] - wall.upper[axis] : wall.lower[axis] - bodies.upper[axis];
      if (gap <= -reach || gap <= widest) continue;
      widest = gap;
      side = {axis, upper};
    }
  }
  return side;
}

bool may_be_thin(const BoundaryCase& boundary) {
  return row_of(boundary.kind).is_wall && boundary.geometry.kind == Shape::Kind::box;
}

bool meet(const Box<3>& box, const Shape& wall, int dimension, double margin) {
  for (int a = 0; a < dimension; ++a) {
    if (box.lower[a] > wall.upper[a] + margin) return false;
    if (box.upper[a] < wall.lower[a] - margin) return false;
  }
  return true;
}

/// The box around the bodies that a wall meets, if there are any.
std::optional<Box<3>> box_before(const Shape& wall, const Case& settings) {
  std::optional<Box<3>> all;
  for (const BodyCase& body : settings.bodies) {
    const Box<3> box = bounding_box(body.geometry);
    if (!meet(box, wall, settings.dimension, settings.discretisation.spacing / 2)) continue;
    if (!all) all.emplace();
    all->grow(box);
  }
  return all;
}

/// Makes a wall deeper on the side away from the bodies.
void deepen(Shape& wall, const Side& side, double depth) {
  double &lower = wall.lower[side.axis], &upper = wall.upper[side.axis];
  if (side.upper) {
    lower = std::min(lower, upper - depth);
  } else {
    upper = std::max(upper, lower + depth);
  }
}

/// Makes a wall wider where it covers a face up to its edge or beyond.
void widen(Shape& wall, const Side& side, const Box<3>& bodies, int dimension, double width) {
  constexpr double rounding = 1e-6;
  for (int a = 0; a < dimension; ++a) {
    if (a == side.axis) continue;
    const double slack = rounding * extent(bodies.lower, bodies.upper, a);
    if (wall.lower[a] <= bodies.lower[a] + slack) {
      wall.lower[a] = std::min(wall.lower[a], bodies.lower[a] - width);
    }
    if (wall.upper[a] >= bodies.upper[a] - slack) {
      wall.upper[a] = std::max(wall.upper[a], bodies.upper[a] + width);
    }
  }
}

}  // namespace

std::vector<BoundaryCase> with_deep_walls(const Case& settings) {
  std::vector<BoundaryCase> boundaries = settings.boundaries;
  const Box<3> bodies = box_of_bodies(settings);
  const int dimension = settings.dimension;
  const double h = settings.discretisation.spacing;
  for (BoundaryCase& boundary : boundaries) {
    if (!may_be_thin(boundary)) continue;
    Shape& wall = boundary.geometry;
    const std::optional<Box<3>> held = box_before(wall, settings);
    if (const auto side = side_before_bodies(wall, bodies, dimension)) {
      deepen(wall, *side, enough * h);
    }
    if (!row_of(boundary.kind).is_attached || !held) continue;
    const auto side = side_before_bodies(wall, *held, dimension);
    if (side) widen(wall, *side, *held, dimension, beside * h);
  }
  return boundaries;
}

bool is_too_thin(const Case& settings, const BoundaryCase& wall) {
  if (!may_be_thin(wall)) return false;
  const Shape& box = wall.geometry;
  if (side_before_bodies(box, box_of_bodies(settings), settings.dimension)) return false;
  double thinnest = std::numeric_limits<double>::infinity();
  for (int a = 0; a < settings.dimension; ++a) {
    thinnest = std::min(thinnest, extent(box.lower, box.upper, a));
  }
  return thinnest < ghost_band * settings.discretisation.spacing;
}

}  // namespace pliant::remeshed

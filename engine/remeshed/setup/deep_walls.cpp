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

}  // namespace

std::vector<BoundaryCase> with_deep_walls(const Case& settings) {
  std::vector<BoundaryCase> boundaries = settings.boundaries;
  const Box<3> bodies = box_of_bodies(settings);
  const double depth = enough * settings.discretisation.spacing;
  for (BoundaryCase& boundary : boundaries) {
    if (!may_be_thin(boundary)) continue;
    Shape& wall = boundary.geometry;
    const auto side = side_before_bodies(wall, bodies, settings.dimension);
    if (!side) continue;
    double& lower = wall.lower[side->axis];
    double& upper = wall.upper[side->axis];
    if (side->upper) {
      lower = std::min(lower, upper - depth);
    } else {
      upper = std::max(upper, lower + depth);
    }
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

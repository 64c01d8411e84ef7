#include "engine/point_based/walls_off_the_lattice.hpp"

#include <algorithm>

#include "engine/case/checks/thickness.hpp"
#include "engine/case/placement.hpp"
#include "engine/case/vocabulary/boundary_kinds.hpp"
#include "engine/geometry/plane_across.hpp"

namespace pliant::point_based {

namespace {

bool lies_along_lattice(const Shape& wall) {
  return wall.kind == Shape::Kind::box || is_plane_along_lattice(wall);
}

/// Whether a ball is inside the bodies, which then have to follow its surface all around.
bool is_core(const Shape& wall, const Box<3>& bodies, int dimension) {
  if (wall.kind != Shape::Kind::ball) return false;
  for (int a = 0; a < dimension; ++a) {
    if (wall.centre[a] - wall.radius < bodies.lower[a]) return false;
    if (wall.centre[a] + wall.radius > bodies.upper[a]) return false;
  }
  return true;
}

// Balls that bodies meet from one side cause errors of 2 % at most, and so do cylinders. Holes of
// collars meet the free surface alone.
bool is_off_the_lattice(const Case& a_case, const BoundaryCase& boundary) {
  const Shape& wall = boundary.geometry;
  if (!row_of(boundary.kind).is_attached || lies_along_lattice(wall)) return false;
  return boundary.kind == BoundaryCase::Kind::slip_wall || wall.kind == Shape::Kind::half_space ||
         is_core(wall, box_of_bodies(a_case), a_case.dimension);
}

}  // namespace

// Measured for parts of rings, for blocks, and for rings around a rigid core, docs/decisions/0066.
void warn_of_walls_off_the_lattice(const Case& a_case, std::vector<std::string>& warnings) {
  static constexpr ThinBodyError errors[] = {
      {7.5,
       "displacements and forces deviate by up to 10 %, and within two spacings of a wall by more, "
       "since it is curved or lies at an angle to the lattice"},
      {13,
       "displacements and forces deviate by up to 3 %, and within two spacings of a wall by more, "
       "since it is curved or lies at an angle to the lattice"}};
  const bool are_off = std::ranges::any_of(a_case.boundaries, [&](const BoundaryCase& boundary) {
    return is_off_the_lattice(a_case, boundary);
  });
  if (are_off) warn_of_thin_bodies(a_case, errors, warnings);
}

}  // namespace pliant::point_based

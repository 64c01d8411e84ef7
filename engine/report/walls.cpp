#include "engine/report/walls.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/geometry/signed_distance.hpp"
#include "engine/report/solid_surface.hpp"

namespace pliant::report {

namespace {

constexpr int cells_2d = 240;  // along the longest side of the sampled box

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector between(const Vector& a, const Vector& b, double share) {
  return {a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2])};
}

Box<3> intersection(Box<3> a, const Box<3>& b) {
  for (int i = 0; i < 3; ++i) {
    a.lower[i] = std::max(a.lower[i], b.lower[i]);
    a.upper[i] = std::min(a.upper[i], b.upper[i]);
  }
  return a;
}

bool is_empty(const Box<3>& box, int dimension) {
  for (int a = 0; a < dimension; ++a) {
    if (box.lower[a] >= box.upper[a]) return true;
  }
  return false;
}

void add_polygon(const std::vector<Vector>& corners, WallPicture& wall) {
  const auto first = static_cast<std::uint32_t>(wall.vertex.size());
  wall.vertex.insert(wall.vertex.end(), corners.begin(), corners.end());
  for (std::uint32_t i = 2; i < corners.size(); ++i) {
    wall.triangle.insert(wall.triangle.end(), {first, first + i - 1, first + i});
  }
}

Vector corner_of(const Box<3>& box, int number) {
  Vector corner = {};
  for (int a = 0; a < 3; ++a) corner[a] = (number >> a & 1) != 0 ? box.upper[a] : box.lower[a];
  return corner;
}

/// Where the face of a half-space crosses the edges of a box, in order around the normal.
std::vector<Vector> face_in(const Box<3>& box, const Shape& shape) {
  std::vector<Vector> corners;
  const auto height = [&](const Vector& x) {
    return dot(shape.normal, x) - dot(shape.normal, shape.point);
  };
  for (int from = 0; from < 8; ++from) {
    for (int a = 0; a < 3; ++a) {
      if ((from >> a & 1) != 0) continue;
      const Vector x = corner_of(box, from), y = corner_of(box, from | 1 << a);
      const double hx = height(x), hy = height(y);
      if ((hx < 0) != (hy < 0)) corners.push_back(between(x, y, hx / (hx - hy)));
    }
  }
  if (corners.size() < 3) return {};
  Vector middle = {};
  for (const Vector& corner : corners) {
    for (int a = 0; a < 3; ++a) middle[a] += corner[a] / static_cast<double>(corners.size());
  }
  const Eigen::Vector3d n(shape.normal.data()), u = n.unitOrthogonal(), v = n.cross(u);
  const auto angle = [&](const Vector& x) {
    const Eigen::Vector3d away = Eigen::Vector3d(x.data()) - Eigen::Vector3d(middle.data());
    return std::atan2(away.dot(v), away.dot(u));
  };
  std::ranges::sort(corners, {}, angle);
  return corners;
}

/// The part of a rectangle inside a half-space.
std::vector<Vector> part_of_rectangle(const Box<3>& box, const Shape& shape) {
  const std::array<Vector, 4> corners = {corner_of(box, 0), corner_of(box, 1), corner_of(box, 3),
                                         corner_of(box, 2)};
  std::vector<Vector> part;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector &x = corners[i], &y = corners[(i + 1) % corners.size()];
    const double hx = signed_distance(shape, x, 2), hy = signed_distance(shape, y, 2);
    if (hx <= 0) part.push_back(x);
    if ((hx < 0) != (hy < 0)) part.push_back(between(x, y, hx / (hx - hy)));
  }
  return part;
}

/// Strips along x of a solid in 2D.
void add_strips(const Shape& shape, const Box<3>& box, WallPicture& wall) {
  const double step = longest_side(box) / cells_2d;
  const auto count = [&](int a) {
    return std::max(1, static_cast<int>(std::ceil((box.upper[a] - box.lower[a]) / step)));
  };
  const int columns = count(0), rows = count(1);
  const double dx = (box.upper[0] - box.lower[0]) / columns;
  const double dy = (box.upper[1] - box.lower[1]) / rows;
  for (int row = 0; row < rows; ++row) {
    const double y = box.lower[1] + row * dy;
    const auto is_inside = [&](int column) {
      return column < columns &&
             signed_distance(shape, {box.lower[0] + (column + 0.5) * dx, y + dy / 2, 0}, 2) < 0;
    };
    for (int first = 0; first < columns; ++first) {
      if (!is_inside(first)) continue;
      int end = first;
      while (is_inside(end)) ++end;
      const double left = box.lower[0] + first * dx, right = box.lower[0] + end * dx;
      add_polygon({{left, y, 0}, {right, y, 0}, {right, y + dy, 0}, {left, y + dy, 0}}, wall);
      first = end;
    }
  }
}

/// The six faces of a box.
void add_box(const Box<3>& box, WallPicture& wall) {
  for (int a = 0; a < 3; ++a) {
    const int u = 1 << (a + 1) % 3, v = 1 << (a + 2) % 3, w = 1 << a;
    add_polygon({corner_of(box, 0), corner_of(box, v), corner_of(box, u + v), corner_of(box, u)},
                wall);
    add_polygon({corner_of(box, w), corner_of(box, w + u), corner_of(box, w + u + v),
                 corner_of(box, w + v)},
                wall);
  }
}

void add_solid(const Shape& shape, const Box<3>& box, int dimension, WallPicture& wall) {
  if (shape.kind == Shape::Kind::half_space) {
    const auto corners = dimension == 3 ? face_in(box, shape) : part_of_rectangle(box, shape);
    if (corners.size() >= 3) add_polygon(corners, wall);
    wall.is_plane = true;
    return;
  }
  const Box<3> part = intersection(bounding_box(shape), box);
  if (is_empty(part, dimension)) return;
  if (dimension == 2) {
    add_strips(shape, part, wall);
  } else if (shape.kind == Shape::Kind::box) {
    add_box(part, wall);
  } else {
    TriangleMesh surface = surface_of_solid(shape, part);
    wall.vertex = std::move(surface.vertex);
    wall.triangle = std::move(surface.triangle);
  }
}

bool is_at_rest(const BoundaryCase& boundary) {
  for (int a = 0; a < 3; ++a) {
    if (boundary.displacement) return false;
    const Expression& velocity = boundary.velocity[a];
    if (!velocity.is_constant() || velocity(0) != 0) return false;
  }
  return true;
}

std::vector<Vector> shifts_of(const BoundaryCase& boundary, const std::vector<double>& times) {
  constexpr int intervals = 20;  // of Simpson's rule, between frames
  std::vector<Vector> shifts;
  if (is_at_rest(boundary)) return shifts;
  shifts.reserve(times.size());
  Vector shift = {};
  double before = 0;
  for (const double time : times) {
    const double step = (time - before) / intervals;
    for (int a = 0; a < 3; ++a) {
      if (boundary.displacement) {
        shift[a] = (*boundary.displacement)[a](time) - (*boundary.displacement)[a](0);
        continue;
      }
      const Expression& u = boundary.velocity[a];
      for (int i = 0; i < intervals; ++i) {
        const double t = before + i * step;
        shift[a] += step / 6 * (u(t) + 4 * u(t + step / 2) + u(t + step));
      }
    }
    shifts.push_back(shift);
    before = time;
  }
  return shifts;
}

void add_rotation(const WallRotation& rotation, const std::vector<double>& times,
                  WallPicture& wall) {
  wall.centre = rotation.centre;
  wall.axis = rotation.axis;
  for (const double time : times) wall.angle.push_back(rotation.angle(time));
  wall.shift.resize(times.size());
}

bool is_wall(BoundaryCase::Kind kind) {
  return kind != BoundaryCase::Kind::pressure && kind != BoundaryCase::Kind::traction;
}

}  // namespace

std::vector<WallPicture> picture_walls(const Case& a_case, const Box<3>& box,
                                       const std::vector<double>& times) {
  std::vector<WallPicture> walls;
  for (const BoundaryCase& boundary : a_case.boundaries) {
    if (!is_wall(boundary.kind)) continue;
    WallPicture wall{.name = boundary.name};
    add_solid(boundary.geometry, box, a_case.dimension, wall);
    if (wall.triangle.empty()) continue;
    wall.shift = shifts_of(boundary, times);
    if (boundary.rotation) add_rotation(*boundary.rotation, times, wall);
    walls.push_back(std::move(wall));
  }
  return walls;
}

}  // namespace pliant::report

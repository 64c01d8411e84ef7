#include "engine/remeshed/contact/relative_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/lattice/point_algebra.hpp"

namespace pliant::remeshed {

namespace {

constexpr double near = 4;          // [h]: farther away a body meets nothing within ten steps
constexpr double small_move = 0.1;  // [h], at walls, and of the wall's normal
// Between bodies [h]. Remeshing smooths the stress where bodies touch. With less, the motion after
// one remeshing of bodies at rest would cause the next one.
constexpr double small_relative_move = 0.3;
constexpr double large_move_of_surface = 2;  // [h]

// Whether a particle at x, which stood at `start`, has another distance from the wall or normal.
template <int D>
bool has_moved_at(const Wall<D>& wall, const Point<D>& start, const Point<D>& x, double h) {
  const double distance = wall.distance(x);
  if (distance > near * h) return false;
  if (std::abs(distance - wall.distance(start)) > small_move * h) return true;
  const Point<D> turn = difference<D>(wall.normal(x), wall.normal(start));
  return dot<D>(turn, turn) > small_move * small_move;
}

// Calls f(slot, position) for the particles that ghosts read.
template <class T, int D, class F>
void for_each_at_surface(const Body<T, D>& body, F&& f) {
  for (const std::int32_t slot : body.population.slot_of_record) {
    f(slot, body.position(slot, body.population.layout.cell(slot)));
  }
}

template <int D>
struct Range {
  Point<D> lower, upper;

  Range() {
    lower.fill(std::numeric_limits<double>::infinity());
    upper.fill(-std::numeric_limits<double>::infinity());
  }
  void add(const Point<D>& x) {
    for (int a = 0; a < D; ++a) {
      lower[a] = std::min(lower[a], x[a]);
      upper[a] = std::max(upper[a], x[a]);
    }
  }
  bool is_wider_than(double width) const {
    for (int a = 0; a < D; ++a) {
      if (upper[a] - lower[a] > width) return true;
    }
    return false;
  }
};

template <class T, int D>
Point<D> displacement_of(const Body<T, D>& body, std::int32_t slot) {
  Point<D> displacement;
  for (int a = 0; a < D; ++a) displacement[a] = body.stage[0].get(Field::drift, a)[slot];
  return displacement;
}

template <class T, int D>
Range<D> surface_range(const Body<T, D>& body) {
  Range<D> range;
  for_each_at_surface(body, [&](std::int32_t, const Point<D>& x) { range.add(x); });
  return range;
}

// Adds the displacements of those particles of a body that are within `margin` of a range.
template <class T, int D>
void add_displacements(const Body<T, D>& body, const Range<D>& around, double margin,
                       Range<D>& displacements) {
  for_each_at_surface(body, [&](std::int32_t slot, const Point<D>& x) {
    for (int a = 0; a < D; ++a) {
      if (body.lattice.period[a] != 0) continue;
      if (x[a] < around.lower[a] - margin || x[a] > around.upper[a] + margin) return;
    }
    displacements.add(displacement_of(body, slot));
  });
}

}  // namespace

template <class T, int D>
bool has_moved_at_walls(const Body<T, D>& body, const Boundaries<D>& boundaries,
                        const std::vector<WallPose<D>>& remeshed) {
  const double h = body.lattice.spacing, square = small_move * small_move * h * h;
  for (std::size_t w = 0; w < boundaries.walls.size(); ++w) {
    const Wall<D>& wall = boundaries.walls[w];
    if (wall.is_attached()) continue;
    const Point<D> moved = difference<D>(wall.pose().offset, remeshed[w].offset);
    if (dot<D>(moved, moved) > square) return true;
    for (const std::int32_t slot : body.population.slot_of_record) {
      const Cell<D> cell = body.population.layout.cell(slot);
      Point<D> start = body.lattice.node(cell);  // as the wall sees it
      for (int a = 0; a < D; ++a) start[a] += moved[a];
      if (has_moved_at<D>(wall, start, body.position(slot, cell), h)) return true;
    }
  }
  return false;
}

template <class T, int D>
bool have_moved_apart(const Body<T, D>& one, const Body<T, D>& other) {
  const double h = one.lattice.spacing;
  Range<D> displacements;
  add_displacements(one, surface_range(other), near * h, displacements);
  add_displacements(other, surface_range(one), near * h, displacements);
  return displacements.is_wider_than(small_relative_move * h);
}

template <class T, int D>
bool surface_has_crossed_rows(const Body<T, D>& body) {
  Range<D> displacements;
  for (const std::int32_t slot : body.population.slot_of_record) {
    displacements.add(displacement_of(body, slot));
  }
  return displacements.is_wider_than(large_move_of_surface * body.lattice.spacing);
}

template bool has_moved_at_walls<double, 2>(const Body<double, 2>&, const Boundaries<2>&,
                                            const std::vector<WallPose<2>>&);
template bool has_moved_at_walls<double, 3>(const Body<double, 3>&, const Boundaries<3>&,
                                            const std::vector<WallPose<3>>&);
template bool has_moved_at_walls<float, 2>(const Body<float, 2>&, const Boundaries<2>&,
                                           const std::vector<WallPose<2>>&);
template bool has_moved_at_walls<float, 3>(const Body<float, 3>&, const Boundaries<3>&,
                                           const std::vector<WallPose<3>>&);
template bool have_moved_apart(const Body<double, 2>&, const Body<double, 2>&);
template bool have_moved_apart(const Body<double, 3>&, const Body<double, 3>&);
template bool have_moved_apart(const Body<float, 2>&, const Body<float, 2>&);
template bool have_moved_apart(const Body<float, 3>&, const Body<float, 3>&);
template bool surface_has_crossed_rows(const Body<double, 2>&);
template bool surface_has_crossed_rows(const Body<double, 3>&);
template bool surface_has_crossed_rows(const Body<float, 2>&);
template bool surface_has_crossed_rows(const Body<float, 3>&);

}  // namespace pliant::remeshed

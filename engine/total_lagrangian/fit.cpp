#include "engine/total_lagrangian/fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/geometry/padded.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/lattice/column.hpp"
#include "engine/total_lagrangian/overhang_fit.hpp"
#include "engine/total_lagrangian/shifted_cells.hpp"

// A wall holds the particles within half a spacing of it. They move onto its surface, so that the
// body is held where the wall is. Where a wall ends on a free surface, the boundary between held
// and free particles would be a staircase around the true rim:
//
//       x x x x x          x held     particles of the surface, seen from above;
//       o o x x x          o free     the rim runs through them at a slant
//       o o o o x
//
// Held particles near the rim therefore move onto it, within the surface. Particles next to moved
// ones move too, less with growing distance.
namespace pliant::total_lagrangian {

namespace {

constexpr double layers = 3;       // over which a shift decays
constexpr double same_face = 0.9;  // cosine between normals of a wall

template <class T, int D>
class WallFitter {
 public:
  WallFitter(const Boundaries<D>& boundaries, const Body<T, D>& body)
      : boundaries_(boundaries),
        body_(body),
        shape_(body.source->geometry),
        h_(body.lattice.spacing),
        held_(body.layout.slots(), false),
        overhangs_(boundaries, body, held_) {
    for (const auto& of_block : body.held) {
      for (const ConstrainedParticle<D>& held : of_block) held_[held.slot] = true;
    }
  }

  WallFit<D> operator()() {
    for_each_particle([&](std::int64_t p, const Cell<D>& cell) {
      if (!is_near_a_wall(cell)) return;
      const std::optional<Column<D>> shift = is_on_surface(p) && !overhangs_.overhangs(cell)
                                                 ? shift_of_surface(p, cell)
                                                 : std::nullopt;
      if (shift && shift->norm() > on_surface * h_) spread_below(cell, *shift);
      if (!shift || wall_continues_inside(cell)) shift_onto_walls(p, cell);
    });
    const ShiftedCells<T, D> cells(body_, held_);
    cells.keep_open(shift_);
    WallFit<D> fit;
    fit.nodes.reserve(shift_.size());
    for (const auto& [slot, shift] : shift_) fit.nodes.push_back({slot, as_point<D>(shift)});
    fit.flat_cells = cells.flat(shift_);
    return fit;
  }

 private:
  template <class F>
  void for_each_particle(F&& f) const {
    for (const Block<D>& block : body_.layout.blocks()) {
      body_.layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
        if (body_.is_particle(p)) f(p, cell);
      });
    }
  }

  double phi(const Column<D>& x) const {
    return signed_distance(shape_, padded<D>(as_point<D>(x)), D);
  }
  bool is_on_surface(std::int64_t p) const { return std::abs(body_.level_set[p]) < h_ / 2; }
  bool is_near_a_wall(const Cell<D>& cell) const {
    return boundaries_.nearest_wall(body_.lattice.node(cell)).second < 2 * h_;
  }

  // Walls are treated in turn: where two meet, a particle moves onto both.
  void shift_onto_walls(std::int64_t p, const Cell<D>& cell) {
    if (!held_[p]) return;
    const Column<D> x = column<D>(body_.lattice.node(cell));
    Column<D> shift = Column<D>::Zero();
    for (const Wall<D>& wall : boundaries_.walls) {
      if (!wall.is_attached()) continue;
      const Point<D> at = as_point<D>(x + shift);
      const double distance = wall.distance(at);
      if (distance > h_ / 2) continue;
      const bool is_deep = distance < -(0.5 + on_surface) * h_;
      if (is_deep && !has_free_before(cell, wall, at)) continue;
      const Column<D> normal = column<D>(wall.normal(at)), onto = -distance * normal;
      shift += onto;
      shift += overhangs_.shift(cell, wall, x + shift);
      if (is_deep || onto.norm() < on_surface * h_) continue;
      const auto [axis, up] = line_along(normal);
      for (int k = 1; k < layers; ++k) {
        Cell<D> beside = cell;
        beside[axis] += up ? k : -k;
        const std::int64_t q = body_.layout.slot(beside);
        if (q >= 0 && body_.is_particle(q) && !held_[q]) take(q, (1 - k / layers) * onto);
      }
    }
    if (shift.norm() > on_surface * h_) take(p, shift);
  }

  // Whether a particle behind a wall is a corner of a cell that the same face of the wall cuts.
  bool has_free_before(const Cell<D>& cell, const Wall<D>& wall, const Point<D>& at) const {
    for (int c = 0; c < (1 << D); ++c) {
      Cell<D> around = cell;
      for (int a = 0; a < D; ++a) around[a] -= c >> a & 1;
      const std::int64_t slot = body_.layout.slot(around);
      if (slot < 0 || !(body_.fraction[slot] > 0)) continue;
      for (const std::int64_t q : body_.corners(around)) {
        if (held_[q]) continue;
        const Point<D> x = body_.lattice.node(body_.layout.cell(q));
        if (wall.distance(x) < (0.5 - on_surface) * h_) continue;  // beyond the rim of an overhang
        if (column<D>(wall.normal(x)).dot(column<D>(wall.normal(at))) > same_face) return true;
      }
    }
    return false;
  }

  // A held particle moves onto the rim within half a spacing; in 3D also one that is diagonally
  // opposite to a free particle.
  std::optional<Column<D>> shift_of_surface(std::int64_t p, const Cell<D>& cell) const {
    if (!held_[p]) return std::nullopt;
    const Column<D> x = column<D>(body_.lattice.node(cell));
    const Column<D> n = normal(x), foot = x - phi(x) * n;
    std::optional<Column<D>> nearest;
    for (const Wall<D>& wall : boundaries_.walls) {
      const std::optional<Column<D>> rim = rim_near(foot, n, wall);
      if (!rim) continue;
      const Column<D> shift = *rim - foot;
      if (!nearest || shift.norm() < nearest->norm()) nearest = shift;
    }
    if (!nearest) return std::nullopt;
    const double distance = nearest->norm() / h_;
    const bool fits = distance < 0.5 || (distance < 1.5 && has_free_opposite(cell, n, *nearest));
    return fits ? nearest : std::nullopt;
  }

  // Whether the wall continues inside the body instead of ending on the surface.
  bool wall_continues_inside(const Cell<D>& cell) const {
    const auto [axis, up] = line_along(normal(column<D>(body_.lattice.node(cell))));
    Cell<D> below = cell;
    below[axis] -= up ? 1 : -1;
    const std::int64_t p = body_.layout.slot(below);
    return p >= 0 && held_[p];
  }

  Column<D> normal(const Column<D>& x) const {
    const Vector n = outward_direction(shape_, padded<D>(as_point<D>(x)), D);
    return Eigen::Map<const Column<D>>(n.data());
  }

  // Newton's method on the surface. The distance from a wall on the surface is 0 there. It is
  // therefore evaluated inside the wall, at decreasing depths, and projected along the side of the
  // wall.
  std::optional<Column<D>> rim_near(const Column<D>& foot, const Column<D>& n,
                                    const Wall<D>& wall) const {
    Column<D> rim = foot, out;
    double depth = 2 * h_;
    for (int k = 0; k < 4; ++k, depth /= 4) {
      const Point<D> at = as_point<D>(rim + depth * n);
      const Column<D> direction = column<D>(wall.normal(at));
      const double slant = direction.dot(n);
      const Column<D> along = direction - slant * n;
      const double square = along.squaredNorm();
      if (square < 0.25) return std::nullopt;  // this is the face of the wall on the body
      rim -= (wall.distance(at) - depth * slant) / square * along;
      out = along / std::sqrt(square);
    }
    // The surface must continue on both sides of the rim and be free on one.
    const Column<D> free = rim + 0.5 * h_ * out, covered = rim - 0.5 * h_ * out;
    if (std::abs(phi(free)) > 0.1 * h_ || std::abs(phi(covered)) > 0.1 * h_) return std::nullopt;
    if (boundaries_.nearest_wall(as_point<D>(free)).second < 0.25 * h_) return std::nullopt;
    return rim;
  }

  // Whether a free particle is diagonally opposite, towards the rim.
  bool has_free_opposite(const Cell<D>& cell, const Column<D>& n, const Column<D>& shift) const {
    bool found = false;
    Cell<D> lower = cell, upper = cell;
    for (int a = 0; a < D; ++a) {
      --lower[a];
      ++upper[a];
    }
    for_each_cell<D>(lower, upper, [&](const Cell<D>& other) {
      Column<D> offset;
      for (int a = 0; a < D; ++a) offset[a] = other[a] - cell[a];
      if (offset.squaredNorm() != 2 || std::abs(offset.dot(n)) > 0.5 || offset.dot(shift) <= 0) {
        return;
      }
      const std::int64_t q = body_.layout.slot(other);
      found = found || (q >= 0 && body_.is_particle(q) && is_on_surface(q) && !held_[q]);
    });
    return found;
  }

  // Spreads a shift along the lattice line nearest to the normal.
  void spread_below(const Cell<D>& cell, const Column<D>& shift) {
    const auto [axis, up] = line_along(normal(column<D>(body_.lattice.node(cell))));
    for (int k = -1; k < layers; ++k) {
      Cell<D> at = cell;
      at[axis] -= up ? k : -k;
      const std::int64_t p = body_.layout.slot(at);
      if (p < 0 || !body_.is_particle(p) || (k != 0 && is_on_surface(p))) continue;
      take(p, (1 - std::abs(k) / layers) * shift);
    }
  }

  // The axis of the lattice line nearest to `n`, and whether `n` points along it.
  static std::pair<int, bool> line_along(const Column<D>& n) {
    int axis = 0;
    n.cwiseAbs().maxCoeff(&axis);
    return {axis, n[axis] > 0};
  }

  // Keeps the longest of several shifts.
  void take(std::int64_t p, const Column<D>& shift) {
    Column<D>& known =
        shift_.try_emplace(static_cast<std::int32_t>(p), Column<D>::Zero()).first->second;
    if (shift.norm() > known.norm()) known = shift;
  }

  const Boundaries<D>& boundaries_;
  const Body<T, D>& body_;
  const Shape& shape_;
  double h_;
  std::vector<bool> held_;  // [slot]
  OverhangFit<T, D> overhangs_;
  Shifts<D> shift_;
};

}  // namespace

template <class T, int D>
WallFit<D> fit_to_walls(const Boundaries<D>& boundaries, const Body<T, D>& body) {
  return WallFitter<T, D>(boundaries, body)();
}

template WallFit<2> fit_to_walls<double, 2>(const Boundaries<2>&, const Body<double, 2>&);
template WallFit<3> fit_to_walls<double, 3>(const Boundaries<3>&, const Body<double, 3>&);
template WallFit<2> fit_to_walls<float, 2>(const Boundaries<2>&, const Body<float, 2>&);
template WallFit<3> fit_to_walls<float, 3>(const Boundaries<3>&, const Body<float, 3>&);

}  // namespace pliant::total_lagrangian

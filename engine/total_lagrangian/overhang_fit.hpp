#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/boundaries/overhang.hpp"
#include "engine/total_lagrangian/body.hpp"

namespace pliant::total_lagrangian {

/// Fits the particles that walls hold to the rims of overhangs, (TL.11). Keeps references.
template <class T, int D>
class OverhangFit {
 public:
  /// `held` [slot] says which particles walls hold.
  OverhangFit(const Boundaries<D>& boundaries, const Body<T, D>& body,
              const std::vector<bool>& held)
      : boundaries_(boundaries), body_(body), held_(held), h_(body.lattice.spacing) {}

  /// Whether the body overhangs an attached wall next to a node.
  bool overhangs(const Cell<D>& cell) const {
    const Point<D> x = body_.lattice.node(cell);
    return std::ranges::any_of(boundaries_.walls, [&](const Wall<D>& wall) {
      return wall.is_attached() && std::abs(wall.distance(x)) <= h_ && rim(wall, x);
    });
  }

  /// The way from `foot`, the place on a wall to which a held particle has moved, to the rim of an
  /// overhang, if that is less than half a spacing [m].
  Column<D> shift(const Cell<D>& cell, const Wall<D>& wall, const Column<D>& foot) const {
    const auto own = rim(wall, as_point<D>(foot));
    if (!own) return shift_towards_free(cell, wall, foot);
    return own->way.norm() < h_ / 2 ? own->way : Column<D>::Zero();
  }

 private:
  std::optional<WayToRim<D>> rim(const Wall<D>& wall, const Point<D>& x) const {
    return way_to_rim<D>(body_.source->geometry, wall, x, h_);
  }

  // Where a face of the body lies on the wall, only free particles beyond the rim tell where it is.
  Column<D> shift_towards_free(const Cell<D>& cell, const Wall<D>& wall,
                               const Column<D>& foot) const {
    Column<D> shift = Column<D>::Zero();
    double nearest = h_ / 2;
    Cell<D> lower = cell, upper = cell;
    for (int a = 0; a < D; ++a) {
      --lower[a];
      ++upper[a];
    }
    for_each_cell<D>(lower, upper, [&](const Cell<D>& beside) {
      const std::int64_t p = body_.layout.slot(beside);
      if (p < 0 || !body_.is_particle(p) || held_[p]) return;
      const Point<D> x = body_.lattice.node(beside);
      if (std::abs(wall.distance(x)) > h_) return;
      const auto of_free = rim(wall, x);
      if (!of_free || !of_free->is_beyond) return;
      const Column<D> out = -of_free->way.normalized();
      const double inside = (of_free->foot + of_free->way - foot).dot(out);
      if (inside <= 0 || inside >= nearest) return;
      nearest = inside;
      shift = inside * out;
    });
    return shift;
  }

  const Boundaries<D>& boundaries_;
  const Body<T, D>& body_;
  const std::vector<bool>& held_;  ///< [slot]
  double h_;
};

}  // namespace pliant::total_lagrangian

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/blocks/box.hpp"
#include "engine/undeformed/contact/pushed_surface.hpp"
#include "engine/undeformed/state.hpp"

namespace pliant::undeformed {

/// How a surface meets a wall: with its corners alone, with the means of the facets around them,
/// or with corners and the middles between them, (TL.35).
enum class Face { plane, smooth, sharp };

/// How far from a wall a corner may be that meets it with its facets; `half_edge` is half of the
/// longest edge at the corner. A round wall rises above chords by less than a quarter of that.
inline double reach_of_facets(Face face, double half_edge) {
  switch (face) {
    case Face::plane:
      return 0;
    case Face::smooth:
      return half_edge / 4;
    case Face::sharp:
      return half_edge;
  }
  return half_edge;
}

/// A wall during a step.
template <int D>
struct MetWall {
  int number;  ///< index in the boundaries
  const BoundaryCase* source;
  RigidStep<D> step;   ///< of the wall
  double length;       ///< of the step [s]
  double kick, drift;  ///< how long forces act, and particles move at the new velocities [s]
  double inertia;      ///< ratio of the impulse to that on the unscaled mass
  Face face;           ///< how a surface meets it
  double friction;     ///< coefficient; infinite for no-slip
  Box<3> box;          ///< around the solid at rest; infinite if the wall turns
};

/// Finds the corners that are near walls. Most are far from all of them. A search lists those that
/// are nearer to a wall than a reach; the list lasts until surface and wall may have approached
/// each other by that. Most searches look through the list of a rare one with a larger reach. A
/// corner that accelerates faster than expected is found, and pushed back, by the next search. The
/// state keeps the lists, so that a resumed run has the same.
template <class T, int D>
class WallSearch {
 public:
  using Surfaces = std::vector<PushedSurface<T, D>>;

  WallSearch(State<D>& state, double spacing) : state_(state), spacing_(spacing) {}

  /// Forgets all lists; these are the surfaces and walls of later calls.
  void begin(const Surfaces& surfaces, const std::vector<MetWall<D>>& walls);
  /// Makes the lists again that are due: `state.near_walls[w].soon` of each wall.
  void update(const Surfaces& surfaces, const std::vector<MetWall<D>>& walls);

  /// Whether x, at the start of the step, may be nearer than `reach` to a wall.
  bool may_reach(const MetWall<D>& wall, const Point<D>& x, double reach) const;
  /// Whether a corner may be.
  bool may_touch(const PushedSurface<T, D>& surface, std::int32_t corner, const MetWall<D>& wall,
                 double reach) const;

 private:
  /// `speed` is the largest of the surfaces [m/s].
  void search(std::size_t w, const Surfaces& surfaces, const MetWall<D>& wall, double speed);
  /// Lists those of the corners `among` [surface] that are nearer to a wall than `reach`.
  void list(std::size_t w, const Surfaces& surfaces, const MetWall<D>& wall, double reach,
            const std::vector<std::vector<std::int32_t>>& among, NearCorners& near) const;
  std::vector<bool> spared_by(const MetWall<D>& wall, const PushedSurface<T, D>& surface) const;

  State<D>& state_;
  double spacing_;                                      ///< [m]
  std::vector<std::vector<std::int32_t>> all_corners_;  ///< [surface]
  /// [wall][surface][corner] what an attached wall never pushes: corners next to it at the start.
  std::vector<std::vector<std::vector<bool>>> spared_;
};

extern template class WallSearch<double, 2>;
extern template class WallSearch<double, 3>;
extern template class WallSearch<float, 2>;
extern template class WallSearch<float, 3>;

}  // namespace pliant::undeformed

#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "engine/point_based/observe/opened_surface.hpp"
#include "engine/point_based/surface/surface.hpp"
#include "tests/engine/point_based/blocks.hpp"

namespace pliant::test {

/// A cube [0, 1]^D with a cut body for its surfaces, and the cuts that a test makes.
template <int D>
struct CutBlock {
  PointSolver<D> solver = PointSolver<D>(
      tests::read_text(
          free_points(D) +
          (D == 2 ? "[[cut]]\nname = \"none\"\nfrom = [-1, -1]\npath = [0, 0]\nend = 1e-9\n"
                  : "[[cut]]\nname = \"none\"\nfrom = [-1, -1, 0]\nto = [-1, -1, 1]\n"
                    "path = [0, 0, 0]\nend = 1e-9\n")),
      {1, kernels::widest_supported()});
  std::vector<point_based::CutSurface<D>> cuts;
  point_based::SurfaceVertices vertices;

  point_based::Body<double, D>& body() { return solver.state().bodies[0]; }

  point_based::CutSurface<D>& add_cut() { return cuts.emplace_back(); }

  template <class F>
  void move(F&& displacement) {
    body().for_each_node([&](std::int64_t slot) {
      const Point<D> u = displacement(body().start[slot]);
      for (int a = 0; a < D; ++a) body().displacement[a][slot] = u[a];
    });
  }

  /// Fills `vertices`, and returns the divided surface.
  point_based::DividedSurface<D> surface() {
    point_based::OpenedSurface<D> opened(body(), 0.125,
                                         point_based::inside_of<D>(body().source->geometry, 1e-7));
    opened.follow(cuts);
    vertices = {};
    opened.add(body(), 7, vertices);
    return opened.undeformed();
  }
};

/// The blade: a point (2D), or a line from z = `bottom` to z = 1.1 (3D), inclined and extended by
/// `tilt`.
template <int D>
std::vector<Point<D>> station(double x, double y, double bottom = -0.1,
                              const Point<3>& tilt = {0, 0, 1.2}) {
  if constexpr (D == 2) {
    return {{x, y}};
  } else {
    return {{x, y, bottom}, {x + tilt[0], y + tilt[1], bottom + tilt[2]}};
  }
}

template <int D>
void sweep(point_based::CutSurface<D>& cut, const Point<3>& from, const Point<3>& to, int stations,
           const Point<3>& tilt = {0, 0, 1.2}) {
  for (int i = 0; i <= stations; ++i) {
    const double s = static_cast<double>(i) / stations;
    cut.add_station(station<D>(from[0] + s * (to[0] - from[0]), from[1] + s * (to[1] - from[1]),
                               from[2] + s * (to[2] - from[2]), tilt));
  }
}

}  // namespace pliant::test

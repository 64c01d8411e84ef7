#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/case/blade_track.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/lattice/point_algebra.hpp"

namespace pliant::point_based {

/// Places of the surfaces that the blades of the case will sweep in a body, (PB.63), no farther
/// apart than `pitch` [m] along the edge and along the path. Blades that wait for a caller are
/// unknown.
template <int D>
class CutPlaces {
 public:
  CutPlaces(const Case& settings, const BodyCase& body, double pitch)
      : box_(bounding_box(body.geometry)), pitch_(pitch) {
    const auto number = &body - settings.bodies.data();
    for (const CutCase& cut : settings.cuts) {
      if (cut.body == number && moves_in_run(cut, settings)) sweep(cut);
    }
  }

  std::vector<Point<D>> take() { return std::move(places_); }

 private:
  void sweep(const CutCase& cut) {
    const std::vector<BladeEdge> path = edges_along_path(cut);
    for (int k = 0; k < path_intervals; ++k) {
      const BladeEdge &from = path[k], &to = path[k + 1];
      const int parts = count(std::max(apart(from.from, to.from), apart(from.to, to.to)));
      for (int i = 0; i < parts; ++i) add(edge_on_path(cut, k + i / static_cast<double>(parts)));
    }
    add(path.back());
  }

  void add(const BladeEdge& edge) {
    const int parts = D == 2 ? 0 : count(apart(edge.from, edge.to));
    for (int i = 0; i <= parts; ++i) {
      const double share = parts > 0 ? i / static_cast<double>(parts) : 0;
      Point<D> x;
      bool is_near = true;
      for (int a = 0; a < D; ++a) {
        x[a] = edge.from[a] + share * (edge.to[a] - edge.from[a]);
        is_near = is_near && x[a] >= box_.lower[a] - pitch_ && x[a] <= box_.upper[a] + pitch_;
      }
      if (is_near) places_.push_back(x);
    }
  }

  int count(double length) const {
    constexpr double most = 1e5;  // of a blade that moves far beyond the body
    return static_cast<int>(std::clamp(std::ceil(length / pitch_), 1., most));
  }

  static double apart(const Vector& x, const Vector& y) {
    return std::hypot(y[0] - x[0], y[1] - x[1], D == 2 ? 0 : y[2] - x[2]);
  }

  Box<3> box_;
  double pitch_;
  std::vector<Point<D>> places_;
};

}  // namespace pliant::point_based

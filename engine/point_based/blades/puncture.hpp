#pragma once

#include <optional>
#include <vector>

#include "engine/blocks/box.hpp"
#include "engine/point_based/blades/blade_load.hpp"
#include "engine/point_based/body.hpp"
#include "engine/undeformed/contact/carried_points.hpp"

// A blade before it enters a body, (PB.34) and (PB.35).
//
//            |            The edge is a rigid tool: points of it that lie behind the surface push
//            | edge       the facet that is nearest to them. When the mean force reaches the
//     ____   v   ____     threshold of the blade, it enters: from then on it cuts.
//         \__.__/
//           dent
namespace pliant::point_based {

/// The parameters of a step that contact uses.
struct ContactStep {
  double length;   ///< [s]
  double drift;    ///< part of it for which nodes move at their present velocities [s]
  double inertia;  ///< inertia of a node over its mass
};

/// One blade outside one body.
template <class T, int D>
class Puncture {
 public:
  using Edge = std::vector<Point<D>>;  ///< one point in 2D, a polyline in 3D [m]

  /// `threshold` is F_p of (PB.35) [N].
  Puncture(const Body<T, D>& body, double threshold);

  /// Points along an edge, no farther apart than H/2.
  Edge points_of(const Edge& edge) const;
  /// Pushes the surface of `body` out of the way of an edge that has moved from `before` to `now`
  /// in a step. Returns the force on the body and its power.
  BladeLoad<D> push(Body<T, D>& body, const Edge& before, const Edge& now, const ContactStep& step);
  /// Whether the blade enters: the mean force has reached the threshold.
  bool has_entered() const { return mean_force_ >= threshold_; }

  double mean_force() const { return mean_force_; }  ///< F of (PB.35) [N]; 0 before the first touch
  void set_mean_force(double force) { mean_force_ = force; }

 private:
  /// A point of the edge behind a facet.
  struct Touch {
    std::vector<undeformed::Share> shares;  ///< of the nearest point of the facet
    Point<D> normal;                        ///< of the facet, outward
    double gap;                             ///< [m], negative
  };

  std::array<Point<D>, D> corners(const Body<T, D>& body, std::int32_t facet) const;
  std::vector<std::int32_t> facets_near(const Body<T, D>& body, const Edge& points) const;
  std::optional<Touch> touch(const Body<T, D>& body, const std::vector<std::int32_t>& facets,
                             const Point<D>& x) const;

  double threshold_;
  double time_constant_;  ///< of the mean force [s]
  double size_;           ///< H [m]
  undeformed::HeldDirections<D> held_;
  double mean_force_ = 0;
};

extern template class Puncture<double, 2>;
extern template class Puncture<double, 3>;
extern template class Puncture<float, 2>;
extern template class Puncture<float, 3>;

}  // namespace pliant::point_based

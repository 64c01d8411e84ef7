#pragma once

#include <vector>

#include "engine/undeformed/contact/moving_surface.hpp"

namespace pliant::undeformed {

/// Two surfaces that are tied: corners of one that touch the other at the start stay where they are
/// on its facets, (TL.21).
template <class T, int D>
class TiedSurfaces {
 public:
  /// Ties the corners of the surface with the smaller facets, or those of the first one.
  TiedSurfaces(MovingSurface<T, D>& first, MovingSurface<T, D>& second, int contact);

  /// The contact of the case.
  int contact() const { return contact_; }
  /// Whether any corner touches at the start.
  bool hold() const { return !ties_.empty(); }
  /// Lets the surfaces watch what is tied.
  void watch();
  /// Finds how far tied points have come apart at the end of a step.
  void measure();
  /// One Gauss-Seidel sweep over all ties.
  void sweep();
  /// Impulse on the first body in this step, of the unscaled mass [N s].
  Point<D> impulse() const;

 private:
  struct Tie {
    std::int32_t corner = -1, facet = -1;
    std::array<double, D> weight = {};           ///< of the facet's corners at the tied point
    double height = 0;                           ///< of the corner over the facet, at the start [m]
    std::size_t first_share = 0, end_share = 0;  ///< of that point
    double compliance = 0;                       ///< of both, without walls [1/kg]
    Point<D> apart = {};                         ///< of the corner from where it should be [m]
    Point<D> pulled = {};                        ///< impulse on the corner [N s]
  };
  void tie(std::int32_t corner, std::span<const std::int32_t> facets);
  std::span<const Share> shares(const Tie& tie) const {
    return std::span(shares_).subspan(tie.first_share, tie.end_share - tie.first_share);
  }

  MovingSurface<T, D>& corners_;
  MovingSurface<T, D>& facets_;
  int contact_;
  double sign_;  ///< 1 where the corners are those of the first body, else -1
  std::vector<Tie> ties_;
  std::vector<Share> shares_;  ///< of the points on facets
};

extern template class TiedSurfaces<double, 2>;
extern template class TiedSurfaces<double, 3>;
extern template class TiedSurfaces<float, 2>;
extern template class TiedSurfaces<float, 3>;

}  // namespace pliant::undeformed

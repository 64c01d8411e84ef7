#pragma once

#include <vector>

#include "engine/undeformed/contact/moving_surface.hpp"

namespace pliant::undeformed {

/// Two tied surfaces: corners of one that touch the other at t = 0 keep their places on its facets,
/// (TL.21).
template <class T, int D>
class TiedSurfaces {
 public:
  /// Ties the corners of the surface with the smaller facets, in a tie those of the first.
  TiedSurfaces(MovingSurface<T, D>& first, MovingSurface<T, D>& second, int contact);

  int contact() const { return contact_; }
  /// Whether any corner touches at t = 0.
  bool hold() const { return !ties_.empty(); }
  /// Makes the surfaces watch what is tied.
  void watch();
  /// Computes the separation of tied points at the end of a step.
  void measure();
  /// One Gauss-Seidel sweep over all ties.
  void sweep();
  /// Impulse on the first body in this step, without mass scaling [N s].
  Point<D> impulse() const;

 private:
  struct Tie {
    std::int32_t corner = -1, facet = -1;
    std::array<double, D> weight = {};           ///< of the facet's corners at the tied point
    double height = 0;                           ///< of the corner above the facet at t = 0 [m]
    std::size_t first_share = 0, end_share = 0;  ///< shares of the tied point
    double compliance = 0;                       ///< of corner and point, without walls [1/kg]
    Point<D> apart = {};   ///< displacement of the corner from its tied place [m]
    Point<D> pulled = {};  ///< impulse on the corner [N s]
  };
  void tie(std::int32_t corner, std::span<const std::int32_t> facets);
  std::span<const Share> shares(const Tie& tie) const {
    return std::span(shares_).subspan(tie.first_share, tie.end_share - tie.first_share);
  }

  MovingSurface<T, D>& corners_;
  MovingSurface<T, D>& facets_;
  int contact_;
  double sign_;  ///< 1 if the corners belong to the first body, else -1
  std::vector<Tie> ties_;
  std::vector<Share> shares_;  ///< of the points on facets
};

extern template class TiedSurfaces<double, 2>;
extern template class TiedSurfaces<double, 3>;
extern template class TiedSurfaces<float, 2>;
extern template class TiedSurfaces<float, 3>;

}  // namespace pliant::undeformed

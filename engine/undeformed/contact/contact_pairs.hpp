#pragma once

#include <span>
#include <vector>

#include "engine/case/case.hpp"
#include "engine/undeformed/contact/corner_search.hpp"

namespace pliant::undeformed {

/// The corners of one body against the facets of another body or of the same one.
template <class T, int D>
struct ContactSide {
  ContactSide(MovingSurface<T, D>& corners, MovingSurface<T, D>& facets, int contact, double sign)
      : corners(corners), facets(facets), search(corners, facets), contact(contact), sign(sign) {}
  MovingSurface<T, D>&corners, &facets;
  CornerSearch<T, D> search;
  int contact;  ///< of the case
  double sign;  ///< 1 if the corners belong to the first body of the contact, else -1
};

/// How long forces act in a step, how long particles move, and how long of that at their final
/// velocities [s].
struct ContactTimes {
  double kick = 0, length = 0, drift = 0;
};

/// A corner, the point that it touches, and the impulses between them.
template <class T, int D>
struct ContactPair {
  const ContactSide<T, D>* side;
  Penetration<D> touch;
  std::size_t first_share, end_share;           ///< shares of the point of the facet
  double compliance = 0;                        ///< along the normal [1/kg]
  double largest_compliance = 0;                ///< as if no wall held the particles [1/kg]
  double approach = 0;                          ///< velocity of approach that it may keep [m/s]
  double normal_impulse = 0, normal_shift = 0;  ///< sums along the normal [N s], [kg m]
};

/// What friction does between a corner and the point that it touches.
template <int D>
struct PairFriction {
  Point<D> impulse = {};  ///< along the surface [N s]
  Point<D> shift = {};    ///< along it, so that other shifts move nothing there [kg m]
  Point<D> slip = {};     ///< velocity of the corner without contact, relative to the point [m/s]
};

/// Corners that touch in a step, and the impulses there, (TL.16).
template <class T, int D>
class ContactPairs {
 public:
  void clear();
  /// Adds those touches to which bodies can respond.
  void add(const ContactSide<T, D>& side, std::span<const Penetration<D>> touches,
           const ContactTimes& times);
  /// One Gauss-Seidel sweep over all pairs, whose changes are multiplied by `relaxation`. Returns
  /// the largest change of the velocity between two [m/s].
  double sweep(std::span<const ContactCase> contacts, const ContactTimes& times, double relaxation);
  const std::vector<ContactPair<T, D>>& all() const { return pairs_; }
  /// [pair] impulse of friction on the corner [N s]
  const Point<D>& friction(std::size_t pair) const { return friction_[pair].impulse; }
  /// Velocity of the corner relative to the point that it touches [m/s].
  Point<D> slip(const ContactPair<T, D>& pair) const { return relative(pair).velocity; }

 private:
  Point<D> face_before(const ContactPair<T, D>& pair, const std::array<Point<D>, D>& c,
                       double drift) const;
  void prepare(ContactPair<T, D>& pair, const ContactTimes& times);
  double push(ContactPair<T, D>& pair, PairFriction<D>& friction, const ContactCase& law,
              double drift, double relaxation);
  static void hold_back(const ContactPair<T, D>& pair, const ContactMotion<D>& motion,
                        double coefficient, double drift, double relaxation,
                        PairFriction<D>& friction);
  ContactMotion<D> relative(const ContactPair<T, D>& pair) const;
  std::span<const Share> corner_shares(const ContactPair<T, D>& pair) const {
    return pair.side->corners.shares(pair.touch.corner);
  }
  std::span<const Share> facet_shares(const ContactPair<T, D>& pair) const {
    return std::span(shares_).subspan(pair.first_share, pair.end_share - pair.first_share);
  }

  std::vector<ContactPair<T, D>> pairs_;
  std::vector<PairFriction<D>> friction_;  ///< [pair] apart, since most sweeps do not need it
  std::vector<Share> shares_;              ///< of the touched points
};

extern template class ContactPairs<double, 2>;
extern template class ContactPairs<double, 3>;
extern template class ContactPairs<float, 2>;
extern template class ContactPairs<float, 3>;

}  // namespace pliant::undeformed

#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/undeformed/advance.hpp"
#include "engine/undeformed/corner_search.hpp"
#include "engine/undeformed/state.hpp"

// Contact between bodies, and of a body with itself.
//
// The corners of a surface must not lie inside another body, and the other way round, (TL.15).
// Those that do after a step are put back onto the nearest point of the surface that they have
// entered. Impulses act between a corner and that point, equal and opposite along the line that
// joined them when the forces of the step acted: momentum is exact, and angular momentum nearly so.
// A corner loses what it approaches by, and friction takes of the slip what Coulomb's law allows
// for that impulse, (TL.16).
//
// Contact has no memory: what acts is a function of the state that a step leaves. No stiffness, so
// no number to choose and no shorter time step.
namespace pliant::undeformed {

template <class T, int D>
class BodyContact {
 public:
  BodyContact(State<D>& state, const Case& settings);

  /// Takes the surfaces of all bodies, which must stay where they are, where the case has contacts;
  /// contact_surface(body) makes them.
  template <class Bodies>
  void take_surfaces(Bodies& bodies) {
    if (settings_.contacts.empty()) return;
    surfaces_.clear();
    for (auto& body : bodies) {
      surfaces_.push_back(std::make_unique<Surface>(body, contact_surface(body)));
    }
    face_each_other();
  }

  /// Lets bodies push each other that have moved for `length` [s], for `drift` [s] of it at the
  /// velocities that they have now, with forces that acted on them for `kick` [s]; adds impulses
  /// and the loss by friction to the state. Tells of a corner that lies deeper than the way out is
  /// known for.
  std::optional<Overlap> apply(double kick, double length, double drift);

 private:
  using Surface = MovingSurface<T, D>;
  /// The corners of one body against the facets of another, or of the same.
  struct Side {
    Side(const Surface& corners, const Surface& facets, int contact, double sign)
        : corners(corners), facets(facets), search(corners, facets), contact(contact), sign(sign) {}
    const Surface &corners, &facets;
    CornerSearch<T, D> search;
    int contact;
    double sign;  ///< 1 where the corners are those of the first body of the contact, else -1
  };
  /// A corner and what it touches.
  struct Meeting {
    const Side* side;
    Touch<D> touch;
    std::size_t first_share, end_share;  ///< of the point of the facet
    double compliance;                   ///< along the normal [1/kg]
    double largest_compliance;           ///< of particles that no wall holds [1/kg]
    double approach;                     ///< that it may keep [m/s]
    Point<D> apart;                      ///< displacement of the corner less that of the point [m]
    double pushed = 0, moved = 0;        ///< along the normal [N s], [kg m]
    Point<D> rubbed = {};                ///< along the surface [N s]
  };

  /// How the bodies of a contact have moved since the lists were made.
  struct Approach {
    double free = 0;      ///< how far they may, both together, before the next lists [m]
    double moved = 0;     ///< how far they have [m]
    Point<D> frame = {};  ///< what they have moved by together [m]
  };

  void face_each_other();
  void list();
  bool lists_last();
  void meet(const Side& side, double length, double drift);
  void find_point(Meeting& meeting);
  void meet_before(Meeting& meeting, double drift);
  void push(Meeting& meeting, double drift);
  Point<D> relative(const Meeting& meeting, const std::array<Buffer<T>, D>& of_corner,
                    const std::array<Buffer<T>, D>& of_facet) const;
  Point<D> slip(const Meeting& meeting) const;
  std::span<const Share> corner_shares(const Meeting& meeting) const {
    return meeting.side->corners.surface().shares(meeting.touch.corner);
  }
  std::span<const Share> facet_shares(const Meeting& meeting) const {
    return {shares_.data() + meeting.first_share, shares_.data() + meeting.end_share};
  }
  void add_totals(double kick);
  std::optional<Overlap> deepest() const;

  State<D>& state_;
  const Case& settings_;
  std::vector<std::unique_ptr<Surface>> surfaces_;  ///< [body]
  std::vector<std::unique_ptr<Side>> sides_;
  std::vector<Approach> approaches_;  ///< [contact]
  bool has_lists_ = false;
  std::vector<Touch<D>> touches_;  ///< room
  std::vector<Meeting> meetings_;  ///< of the present step
  std::vector<Share> shares_;      ///< of its points of facets
};

extern template class BodyContact<double, 2>;
extern template class BodyContact<double, 3>;
extern template class BodyContact<float, 2>;
extern template class BodyContact<float, 3>;

}  // namespace pliant::undeformed

#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/method/phase_rows.hpp"
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

/// The resources of a method that contact reads and writes.
struct ContactFields {
  Resources motion;     ///< displacements that a step leaves, and velocities
  Resources constants;  ///< masses, and what walls hold
  Resources lists, places, normals, touches;
};

template <class T, int D>
class BodyContact {
 public:
  /// A step leaves the displacements of a body in its member `moved`.
  BodyContact(State<D>& state, const Case& settings, Displacements<T, D> moved);

  /// Takes the surfaces of all bodies, which must stay where they are, where the case has contacts;
  /// contact_surface(body) makes them.
  template <class Bodies>
  void take_surfaces(Bodies& bodies) {
    if (settings_.contacts.empty()) return;
    surfaces_.clear();
    for (auto& body : bodies) {
      surfaces_.push_back(std::make_unique<Surface>(body, moved_, contact_surface(body)));
    }
    face_each_other();
  }

  /// Says that bodies move for `length` [s] in the next step, for `drift` [s] of it at the
  /// velocities that they have in the end, with forces that act on them for `kick` [s].
  void prepare(double kick, double length, double drift);

  /// Where the case has contacts, adds what lets bodies that have moved push each other: blocks
  /// share the search among them, and one thread does the sweeps, which add impulses and the loss
  /// by friction to the state.
  void add_phases(PhaseRows& rows, const ContactFields& fields);

  /// Whether the case has contacts.
  bool exists() const { return !sides_.empty(); }

  /// A corner that lies deeper than the way out is known for.
  std::optional<Overlap> deepest() const;

 private:
  using Surface = MovingSurface<T, D>;
  /// The corners of one body against the facets of another, or of the same.
  struct Side {
    Side(Surface& corners, Surface& facets, int contact, double sign)
        : corners(corners), facets(facets), search(corners, facets), contact(contact), sign(sign) {}
    Surface &corners, &facets;
    CornerSearch<T, D> search;
    int contact;
    double sign;  ///< 1 where the corners are those of the first body of the contact, else -1
  };
  /// A corner and what it touches.
  struct Meeting {
    const Side* side;
    const std::vector<Share>* shares;
    Touch<D> touch;
    std::size_t first_share, end_share;  ///< of the point of the facet, in `shares`
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

  /// What a block finds.
  struct Found {
    std::vector<Touch<D>> touches;
    std::vector<Meeting> meetings;
    std::vector<Share> shares;
  };

  void face_each_other();
  void look();
  void list();
  bool lists_last();
  void find_places(int block);
  void find_normals(int block);
  void search(int block);
  void sweep();
  void meet(const Side& side, Found& found);
  void meet_before(Meeting& meeting, std::vector<Share>& shares);
  void push(Meeting& meeting);
  Point<D> relative(const Meeting& meeting, const std::array<Buffer<T>, D>& of_corner,
                    const std::array<Buffer<T>, D>& of_facet) const;
  Point<D> displaced(const Meeting& meeting) const;
  Point<D> slip(const Meeting& meeting) const;
  std::span<const Share> corner_shares(const Meeting& meeting) const {
    return meeting.side->corners.surface().shares(meeting.touch.corner);
  }
  std::span<const Share> facet_shares(const Meeting& meeting) const {
    return std::span(*meeting.shares)
        .subspan(meeting.first_share, meeting.end_share - meeting.first_share);
  }
  void add_totals();

  State<D>& state_;
  const Case& settings_;
  Displacements<T, D> moved_;
  double kick_ = 0, length_ = 0, drift_ = 0;
  std::vector<std::unique_ptr<Surface>> surfaces_;  ///< [body]
  std::vector<std::unique_ptr<Side>> sides_;
  std::vector<Approach> approaches_;  ///< [contact]
  bool has_lists_ = false;
  bool may_touch_ = false;    ///< in the present step
  std::vector<Found> found_;  ///< [block] in the present step
};

extern template class BodyContact<double, 2>;
extern template class BodyContact<double, 3>;
extern template class BodyContact<float, 2>;
extern template class BodyContact<float, 3>;

}  // namespace pliant::undeformed

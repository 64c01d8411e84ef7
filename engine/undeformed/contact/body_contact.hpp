#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/method/phase_rows.hpp"
#include "engine/undeformed/advance.hpp"
#include "engine/undeformed/contact/meetings.hpp"
#include "engine/undeformed/contact/tied_surfaces.hpp"
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

/// Keeps the surfaces of bodies out of each other, (TL.15), and ties those that are `tied`.
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
  bool exists() const { return !sides_.empty() || !ties_.empty(); }

  /// A corner that lies deeper than the way out is known for.
  std::optional<Overlap> deepest() const;

 private:
  using Surface = MovingSurface<T, D>;
  using Side = ContactSide<T, D>;

  /// What a block finds.
  struct Found {
    std::vector<Touch<D>> touches;
    Meetings<T, D> meetings;
  };

  void face_each_other();
  void tie(int contact);
  void look();
  void list();
  void take_marks();
  void give_marks();
  void read_motion();
  bool lists_hold();
  void find_places(int block);
  void find_normals(int block);
  void search(int block);
  void sweep();
  void add_totals();
  void add_force(int contact, const Point<D>& impulse);

  State<D>& state_;
  const Case& settings_;
  Displacements<T, D> moved_;
  ContactTimes times_;
  std::vector<std::unique_ptr<Surface>> surfaces_;  ///< [body]
  std::vector<std::unique_ptr<Side>> sides_;
  std::vector<TiedSurfaces<T, D>> ties_;
  bool acts_ = false;         ///< bodies may touch in the present step, or are tied
  std::vector<Found> found_;  ///< [block] in the present step
};

extern template class BodyContact<double, 2>;
extern template class BodyContact<double, 3>;
extern template class BodyContact<float, 2>;
extern template class BodyContact<float, 3>;

}  // namespace pliant::undeformed

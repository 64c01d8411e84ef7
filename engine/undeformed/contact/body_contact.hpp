#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/method/phase_rows.hpp"
#include "engine/undeformed/advance.hpp"
#include "engine/undeformed/contact/contact_pairs.hpp"
#include "engine/undeformed/contact/tied_surfaces.hpp"
#include "engine/undeformed/state.hpp"

// Contact between bodies, and of a body with itself.
//
// The corners of each surface must not lie inside another body, (TL.15). A corner that does after a
// step is moved back onto the nearest point of the surface that it has entered. Equal and opposite
// impulses act on the corner and on that point, along the line that joined them when the forces of
// the step acted: momentum is conserved exactly, and angular momentum almost. A corner loses its
// velocity of approach, and friction reduces the slip as far as Coulomb's law allows for that
// impulse, (TL.16).
//
// Contact has no memory: it depends only on the state after a step. There is no stiffness: no
// parameter to choose, no shorter time step.
namespace pliant::undeformed {

/// The resources of a method that contact reads and writes.
struct ContactFields {
  Resources motion;     ///< displacements at the end of a step, and velocities
  Resources constants;  ///< masses, and which particles walls hold
  Resources lists, places, normals, touches;
};

/// Prevents bodies from overlapping, (TL.15), and ties those that are `tied`.
template <class T, int D>
class BodyContact {
 public:
  /// A step writes the displacements of a body to its member `moved`.
  BodyContact(State<D>& state, const Case& settings, Displacements<T, D> moved);

  /// Makes the surfaces of all bodies with contact_surface(body), if the case has contacts. The
  /// bodies must not move in memory.
  template <class Bodies>
  void take_surfaces(Bodies& bodies) {
    if (settings_.contacts.empty()) return;
    surfaces_.clear();
    for (auto& body : bodies) {
      surfaces_.push_back(std::make_unique<Surface>(body, moved_, contact_surface(body)));
    }
    face_each_other();
  }

  /// Sets the times of the next step [s]: bodies move for `length`, of it for `drift` at their
  /// final velocities, and forces act for `kick`.
  void prepare(double kick, double length, double drift);

  /// Adds the phases of contact, if the case has contacts. Blocks share the search among them. One
  /// thread runs the sweeps, which add impulses and losses by friction to the state.
  void add_phases(PhaseRows& rows, const ContactFields& fields);

  bool exists() const { return !sides_.empty() || !ties_.empty(); }

  /// A corner that is too deep for its way out to be certain.
  std::optional<Overlap> deepest() const;

 private:
  using Surface = MovingSurface<T, D>;
  using Side = ContactSide<T, D>;

  struct Found {
    std::vector<Penetration<D>> touches;
    ContactPairs<T, D> pairs;
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
  int most_sweeps_ = 0;       ///< in a step
  double relaxation_ = 1;     ///< of the sweeps
  bool acts_ = false;         ///< whether bodies may touch in the present step, or are tied
  std::vector<Found> found_;  ///< [block] in the present step
};

extern template class BodyContact<double, 2>;
extern template class BodyContact<double, 3>;
extern template class BodyContact<float, 2>;
extern template class BodyContact<float, 3>;

}  // namespace pliant::undeformed

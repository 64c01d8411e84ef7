#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/blocks/box.hpp"
#include "engine/undeformed/body.hpp"
#include "engine/undeformed/contact/contact_surface.hpp"
#include "engine/undeformed/held_directions.hpp"
#include "engine/undeformed/state.hpp"

// Contact walls: rigid solids of any shape that bodies can meet and leave.
//
// Corners of the present surface must not lie inside a wall, (TL.12). A corner that does after a
// step is moved back onto the wall along the normal, by the smallest change of the particles that
// carry it. If a corner moves with the gradient of a node, that node alone takes the push: with
// wide stencils, many corners would push each other out of the wall. Friction reduces the slip as
// far as Coulomb's law allows for the normal impulse.
//
// If velocities belong to the middle of a step, as with central differences, they change by what
// moves the corner back within the step. If they belong to its end, as with the leapfrog, a corner
// loses its velocity of approach, so that a corner at rest on the wall keeps none. No force ever
// pulls a corner back.
//
// There is no penalty stiffness: no parameter to choose, no shorter time step.
namespace pliant::undeformed {

/// Prevents the surfaces of bodies from entering contact walls, (TL.12).
template <class T, int D>
class WallContact {
 public:
  /// A step writes the displacements of a body to its member `moved`.
  WallContact(State<D>& state, const Case& settings, Displacements<T, D> moved);

  bool exists() const { return !walls_.empty(); }
  /// Which carriers of a corner take the impulse on it.
  enum class ImpulseCarriers { all, first };
  /// Makes the surfaces of all bodies with contact_surface(body), if the case has contact walls.
  /// The bodies must not move in memory.
  template <class Bodies>
  void take_surfaces(Bodies& bodies, ImpulseCarriers bearing) {
    surfaces_.clear();
    if (!exists()) return;
    for (auto& body : bodies) add_surface(body, contact_surface(body), bearing);
  }
  /// Lets the walls push particles that have moved for `length` [s] since `time`, of it for `drift`
  /// [s] at their present velocities, with forces that have acted for `kick` [s]. Adds impulses and
  /// work of the walls to the state.
  void apply(double time, double kick, double length, double drift);

 private:
  /// A corner that can move: walls that hold its particles leave some direction free.
  struct Corner {
    std::int32_t number;
    Share first;
    double compliance;  ///< in the axis direction where it is largest [1/kg]
  };
  struct Surface {
    Body<T, D>* body;
    ContactSurface<D> shape;
    HeldDirections<D> held;
    ImpulseCarriers impulse_carriers;
    std::vector<Corner> corners;
  };
  struct ContactWall {
    int wall;              ///< index in the boundaries
    bool slides;           ///< without friction
    double friction;       ///< coefficient; infinite for no-slip
    RigidStep<D> step;     ///< of the wall
    double inertia;        ///< ratio of the impulse to that on the unscaled mass
    double kick;           ///< how long it acts [s]
    double length, drift;  ///< how long particles move, how long at the present velocities [s]
    /// The smallest box around the solid at rest; infinite if the wall turns.
    Box<3> box;
  };
  /// Whether x is outside the box around a wall, for the wall at the start of the step.
  bool is_outside_box(const ContactWall& wall, const Point<D>& x) const;
  bool may_touch(const Surface& surface, std::int32_t corner, const ContactWall& wall) const;
  static std::span<const Share> impulse_carriers(const Surface& surface, const Corner& corner);
  void add_surface(Body<T, D>& body, ContactSurface<D> surface, ImpulseCarriers bearing);
  void push(Surface& surface, const Corner& corner, const ContactWall& wall);

  State<D>& state_;
  Displacements<T, D> moved_;
  std::vector<ContactWall> walls_;
  std::vector<Surface> surfaces_;
};

extern template class WallContact<double, 2>;
extern template class WallContact<double, 3>;
extern template class WallContact<float, 2>;
extern template class WallContact<float, 3>;

}  // namespace pliant::undeformed

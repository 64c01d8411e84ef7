#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/shape.hpp"
#include "engine/undeformed/body.hpp"
#include "engine/undeformed/contact_surface.hpp"
#include "engine/undeformed/held_directions.hpp"
#include "engine/undeformed/state.hpp"

// Contact walls: rigid solids of any shape that bodies can meet and leave.
//
// The corners of the present surface must not lie inside a wall, (TL.12). One that does after a
// step is put back onto it along the normal, by moving the particles that carry it: the least
// change that does it. Where a corner follows the gradient of a node, that node takes all of it:
// the wide stencils of many corners would push each other out of the wall. Friction takes as much
// of the sliding velocity as Coulomb's law allows for the impulse along the normal.
//
// Where velocities belong to the middle of a step, as with central differences, they change by what
// moves the corner back within the step. Where they belong to its end, as with the leapfrog, a
// corner loses the velocity at which it approaches the wall, so that one at rest on the wall has
// none. No force ever pulls a corner back.
//
// No penalty stiffness, so no number to choose and no shorter time step.
namespace pliant::undeformed {

/// Keeps the surfaces of bodies out of contact walls, (TL.12).
template <class T, int D>
class WallContact {
 public:
  /// A step leaves the displacements of a body in its member `moved`.
  WallContact(State<D>& state, const Case& settings, Displacements<T, D> moved);

  /// Whether the case has contact walls.
  bool exists() const { return !walls_.empty(); }
  /// Which of the particles that carry a corner take the impulse on it.
  enum class Bearers { all, first };
  /// Takes the surfaces of all bodies, which must stay where they are, where the case has contact
  /// walls; contact_surface(body) makes them.
  template <class Bodies>
  void take_surfaces(Bodies& bodies, Bearers bearing) {
    surfaces_.clear();
    if (!exists()) return;
    for (auto& body : bodies) add_surface(body, contact_surface(body), bearing);
  }
  /// Lets the walls push the particles that have moved for `length` [s] from `time` on, for `drift`
  /// [s] of it at the velocities that they have now, with forces that acted on them for `kick` [s];
  /// adds impulses and work of the walls to the state.
  void apply(double time, double kick, double length, double drift);

 private:
  /// A corner that walls which hold particles leave free to move in some direction.
  struct Corner {
    std::int32_t number;
    Share first;
    double compliance;  ///< along the axis where it is largest [1/kg]
  };
  struct Surface {
    Body<T, D>* body;
    ContactSurface<D> shape;
    HeldDirections<D> held;
    Bearers bearers;
    std::vector<Corner> corners;
  };
  struct ContactWall {
    int wall;              ///< its place in the boundaries
    bool slides;           ///< without friction
    double friction;       ///< coefficient; infinite without sliding
    RigidStep<D> step;     ///< of the wall
    double inertia;        ///< impulse over what moves the unscaled mass
    double kick;           ///< for how long it acts [s]
    double length, drift;  ///< for how long particles move, at the present velocities [s]
    /// The least box around the solid at rest; without end where the wall turns.
    Box<3> box;
  };
  /// Whether the box around a wall already tells that x, where the wall is at the start of the
  /// step, is outside it.
  bool is_outside_box(const ContactWall& wall, const Point<D>& x) const;
  bool may_touch(const Surface& surface, std::int32_t corner, const ContactWall& wall) const;
  static std::span<const Share> bearers(const Surface& surface, const Corner& corner);
  void add_surface(Body<T, D>& body, ContactSurface<D> surface, Bearers bearing);
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

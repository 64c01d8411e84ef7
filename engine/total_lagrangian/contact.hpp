#pragma once

#include <vector>

#include "engine/total_lagrangian/state.hpp"

// Contact walls: rigid solids of any shape that bodies can meet and leave.
//
// The corners of the facets of the present surface must not lie inside a wall, (TL.12). One that
// does after a step is put back onto the wall along the normal, by moving the two particles between
// which it lies: the least change of velocity that does it. Friction takes as much of the sliding
// velocity as Coulomb's law allows for the impulse along the normal. Velocities follow: a corner
// has the normal velocity of the wall while it is pressed, and no force ever pulls it back.
//
// No penalty stiffness, so no number to choose and no shorter time step.
namespace pliant::total_lagrangian {

template <class T, int D>
class WallContact {
 public:
  explicit WallContact(State<T, D>& state, const Case& settings);

  /// Lists the corners of the surfaces of all bodies, if there are contact walls.
  void prepare_surfaces();
  /// Lets the walls push the particles that have moved for `length` [s] from `time` on, with forces
  /// that acted on them for `kick` [s]; adds impulses and work of the walls to the state.
  void apply(double time, double kick, double length);

 private:
  /// A corner, on the line between two particles; those that a wall holds do not move.
  struct Corner {
    Vertex<D> vertex;
    double compliance;                       ///< velocity along a force per impulse [1/kg]
    double first_response, second_response;  ///< velocities of the particles per impulse [1/kg]
  };
  struct ContactWall {
    int wall;                  ///< its place in the boundaries
    bool slides;               ///< without friction
    double friction;           ///< coefficient; infinite without sliding
    Point<D> velocity, shift;  ///< of the wall in the step [m/s], [m]
    double inertia;            ///< impulse over what moves the unscaled mass
    double kick;               ///< for how long it acts [s]
  };
  void push(Body<T, D>& body, const Corner& corner, const ContactWall& wall, double length);

  State<T, D>& state_;
  const Case& settings_;
  std::vector<ContactWall> walls_;
  std::vector<std::vector<Corner>> corners_;  ///< [body]
};

extern template class WallContact<double, 2>;
extern template class WallContact<double, 3>;
extern template class WallContact<float, 2>;
extern template class WallContact<float, 3>;

}  // namespace pliant::total_lagrangian

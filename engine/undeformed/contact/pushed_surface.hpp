#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/undeformed/contact/carried_points.hpp"
#include "engine/undeformed/contact/contact_surface.hpp"
#include "engine/undeformed/contact/surface_patches.hpp"
#include "engine/undeformed/state.hpp"

namespace pliant::undeformed {

/// A corner that can move: walls that hold its particles leave some direction free.
struct MovableCorner {
  std::int32_t number;
  double compliance;  ///< in the axis direction where it is largest [1/kg]
};

/// Which carriers of a corner take an impulse on it.
enum class ImpulseCarriers { all, first };

/// The surface of a body that walls may push.
template <class T, int D>
struct PushedSurface {
  Body<T, D>* body;
  Displacements<T, D> moved;  ///< where a step writes displacements
  ContactSurface<D> shape;
  HeldDirections<D> held;
  std::vector<MovableCorner> corners;
  std::size_t inner_corners = 0;  ///< those at the end of the list that are inside the body

  /// With the facets and neighbours of each corner if `meets_tools`.
  PushedSurface(Body<T, D>& of, Displacements<T, D> displacements, ContactSurface<D> surface,
                ImpulseCarriers carriers, bool meets_tools);
  /// Those that are not inside the body.
  std::span<const MovableCorner> outer_corners() const {
    return std::span(corners).first(corners.size() - inner_corners);
  }
  /// What takes the impulses on a corner of the surface.
  std::span<const Share> bearing(std::int32_t corner) const;
  /// Numbers of the facets at a corner.
  std::span<const std::int32_t> facets_at(std::int32_t corner) const;
  /// The other corners of these facets, each once.
  std::span<const std::int32_t> neighbours(std::int32_t corner) const;
  /// Half of the length of their longest edge at the corner, in the undeformed body [m]; 0 without.
  double half_edge(std::int32_t corner) const;
  /// Place at the end of the step [m].
  Point<D> place(std::int32_t corner) const;

 private:
  void find_neighbours();

  std::vector<Share> first_carrier_;                   ///< [corner], unless all take impulses
  Groups facets_at_;                                   ///< [corner], or empty
  std::vector<std::vector<std::int32_t>> neighbours_;  ///< [corner], or empty
  std::vector<double> half_edge_;                      ///< [corner], or empty
};

extern template struct PushedSurface<double, 2>;
extern template struct PushedSurface<double, 3>;
extern template struct PushedSurface<float, 2>;
extern template struct PushedSurface<float, 3>;

}  // namespace pliant::undeformed

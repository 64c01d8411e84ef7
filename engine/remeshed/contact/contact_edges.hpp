#pragma once

#include "engine/boundaries/boundary_values.hpp"
#include "engine/remeshed/contact/wall_cover.hpp"
#include "engine/remeshed/state/state.hpp"
#include "kernels/remeshed/ghosts/ghost_state.hpp"

// The edge of contact, where a side of a body meets a contact wall on which the body presses.
//
//           side
//     body   |  s s s      s  free ghosts next to the side whose fits reach the wall
//     _______|  s s s
//      c c E    e e e      c  ghosts of the wall under the body; E is the one at the edge
//      c c c    e e e      e  ghosts behind the wall and beyond the side
//
// Fits of s and e contain the bottom of the body, on which the wall pushes, as well as its side.
// The bottom is not a free surface, so s must not require zero traction there. A fit extrapolated
// beyond the side does not show whether e is in contact. Therefore e is in contact if E is, and
// while E is in contact, s takes its normal from the side alone, (RP.81).
namespace pliant::remeshed {

/// In place of a slot.
inline constexpr std::int32_t no_edge = -1;

/// Finds the slot E of the ghosts of a new lattice.
template <class T, int D>
class ContactEdges {
 public:
  ContactEdges(const Body<T, D>& body, const Population<T, D>& population,
               const LevelSet<T, D>& level_set, const Boundaries<D>& boundaries)
      : body_(body), population_(population), level_set_(level_set), boundaries_(boundaries) {}

  /// E for a slot at x behind a contact wall, if the body does not cover the wall there and ends on
  /// it nearby. Otherwise no_edge.
  std::int32_t beyond(std::int64_t slot, const Point<D>& x, int wall) const;
  /// E for a slot at x outside the free surface with the closest point `foot`; `up` becomes the
  /// direction from the wall along the side.
  std::int32_t beside(const Point<D>& x, const Point<D>& foot, Point<D>& up) const;

 private:
  std::int32_t under(const Point<D>& edge, const Point<D>& outward, int wall) const;

  const Body<T, D>& body_;
  const Population<T, D>& population_;
  const LevelSet<T, D>& level_set_;
  const Boundaries<D>& boundaries_;
};

/// Activates the wall's ghosts beyond the edges of a block where the slots at the edges are in
/// contact.
template <class T, int D>
void follow_edges(Body<T, D>& body, int block);

/// (RP.81): the traction on a free-surface ghost g next to an edge, and the normal of the side.
template <class T, int D>
kernels::SurfaceLoad<T, D> load_beside_edge(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts,
                                            std::size_t g, const Point<D>& x,
                                            const BoundaryValues<D>& values);

extern template class ContactEdges<double, 2>;
extern template class ContactEdges<double, 3>;
extern template class ContactEdges<float, 2>;
extern template class ContactEdges<float, 3>;

}  // namespace pliant::remeshed

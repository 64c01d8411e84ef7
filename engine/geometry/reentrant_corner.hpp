#pragma once

#include <array>
#include <optional>
#include <span>

#include "engine/geometry/shape.hpp"

/// Re-entrant corners (edges in 3D): where two faces meet that each lie in front of the other, as
/// in the notch of an L.
///
///     body   body   body
///     body   -------------  second
///     body  |  x
///     body  |      x: a node outside
///         first
namespace pliant {

/// A place of a surface, as seen from a node outside the body.
struct Facet {
  Vector foot;    ///< relative to the node, over the spacing
  Vector normal;  ///< unit, out of the body
};

/// Nodes within this distance of the surface, over the spacing, see its corners. Farther away, the
/// closest points of smooth surfaces differ as much.
inline constexpr double farthest_node = 1.1;

/// Whether the surface may be smooth between two facets in adjacent cells.
bool are_alike(const Facet& a, const Facet& b);

/// The faces of a re-entrant corner beside a node, if the facets that the node and those in the
/// cells around it see are not all of one smooth face; that of the node comes first.
std::optional<std::array<Facet, 2>> faces_of_corner(std::span<const Facet> facets);

/// The place nearest to the node where the planes of both facets meet, relative to it, over the
/// spacing.
Vector meeting_place(const std::array<Facet, 2>& faces);

/// Whether a surface has re-entrant corners; `box` contains what is wanted of it. Smaller notches
/// than two spacings may be missed [m].
bool has_reentrant_corner(const Shape& surface, const Shape& box, int dimension, double spacing);

}  // namespace pliant

#pragma once

#include <Eigen/Geometry>

#include "engine/lattice/column.hpp"
#include "engine/lattice/surface_pieces.hpp"
#include "engine/remeshed/state/loaded_facets.hpp"

/// Facets of the surface that move.
namespace pliant::remeshed {

/// Area of a segment or triangle times its normal, which points to the right of the segment.
inline PlaceVector<2> area_of(const std::array<PlaceVector<2>, 2>& x) {
  return {x[1][1] - x[0][1], x[0][0] - x[1][0]};
}
inline PlaceVector<3> area_of(const std::array<PlaceVector<3>, 3>& x) {
  return (x[1] - x[0]).cross(x[2] - x[0]) / 2;
}

/// The least rotation that turns one unit vector into another.
inline Eigen::Matrix2d turn_between(const PlaceVector<2>& from, const PlaceVector<2>& to) {
  const double cosine = from.dot(to), sine = from[0] * to[1] - from[1] * to[0];
  return Eigen::Matrix2d{{cosine, -sine}, {sine, cosine}};
}
inline Eigen::Matrix3d turn_between(const PlaceVector<3>& from, const PlaceVector<3>& to) {
  return Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix();
}

/// Calls f(load, area vector, unit normal of its face) for the loaded parts of a facet that has the
/// area vector `area` [m^2, in 2D m] by now. Its parts turn with it.
template <int D, class F>
void for_each_loaded_part(const FacetParts<D>& facet, const PlaceVector<D>& area, F&& f) {
  const double size = area.norm();
  if (size == 0) return;
  const auto turn = turn_between(column<D>(facet.normal), PlaceVector<D>(area / size));
  for (int k = 0; k < facet.count; ++k) {
    const FacetPart<D>& part = facet.parts[k];
    if (part.load < 0) continue;
    f(part.load, PlaceVector<D>(size * part.share * turn * column<D>(part.area)),
      PlaceVector<D>(turn * column<D>(part.normal)));
  }
}

}  // namespace pliant::remeshed

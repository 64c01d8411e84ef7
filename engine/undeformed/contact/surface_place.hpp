#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/geometry/padded.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/lattice/lattice.hpp"
#include "engine/method/decompositions.hpp"

namespace pliant::undeformed {

/// The part of a body's surface that a point of a facet represents, (TL.29).
template <int D>
struct SurfacePlace {
  Point<D> place;   ///< [m]
  double area = 1;  ///< ratio of its area to that of the facet
};

/// Follows the unit normal of a facet from its point `x` to the surface of `shape`. A facet that
/// cuts off an edge represents the faces that meet there. Returns `x` if the surface is farther
/// away than the spacing `h` [m].
template <int D>
SurfacePlace<D> surface_place(const Shape& shape, const Point<D>& x, const Point<D>& normal,
                              double h) {
  constexpr double reached = 1e-6, on_surface = 1e-9;  // [h]
  constexpr double least_cosine = 0.5;                 // between the facet and the surface
  constexpr int most_steps = 32;
  const auto moved = [&](const Point<D>& from, double way) {
    Point<D> to = from;
    for (int a = 0; a < D; ++a) to[a] += way * normal[a];
    return to;
  };
  double left = signed_distance(shape, padded<D>(x), D);
  if (std::abs(left) <= on_surface * h) return {moved(x, -left)};
  Point<D> place = x;
  double way = 0;
  for (int i = 0; i < most_steps && std::abs(left) > reached * h; ++i) {
    way -= left;
    if (std::abs(way) > h) return {x};
    place = moved(x, way);
    left = signed_distance(shape, padded<D>(place), D);
  }
  const Vector outward = outward_direction(shape, padded<D>(place), D);
  double cosine = 0;
  for (int a = 0; a < D; ++a) cosine += outward[a] * normal[a];
  cosine = std::max(cosine, least_cosine);
  // The last step ends in the plane of the face, up to rounding.
  return {moved(place, -left / cosine), 1 / cosine};
}

/// The share of the way from a place `from` on a face of `shape` to a place outside at which the
/// line leaves the shape, (TL.32). It is 0 unless the line runs along the face.
template <int D>
double way_along_face(const Shape& shape, const Point<D>& from, const Point<D>& to, double h) {
  constexpr double along_face = 1e-7;  // [h]
  constexpr double first_share = 1e-3, accuracy = 1e-9;
  const auto is_inside = [&](double share) {
    Point<D> x;
    for (int a = 0; a < D; ++a) x[a] = (1 - share) * from[a] + share * to[a];
    return signed_distance(shape, padded<D>(x), D) <= along_face * h;
  };
  if (!is_inside(first_share)) return 0;
  double inside = first_share, outside = 1;
  while (outside - inside > accuracy) {
    const double middle = (inside + outside) / 2;
    (is_inside(middle) ? inside : outside) = middle;
  }
  return inside;
}

/// A face of a body that a facet represents, (TL.29).
template <int D>
struct FaceOfFacet {
  Point<D> normal;  ///< unit vector
  double area = 1;  ///< ratio of its area to that of the facet
};

/// The faces of `shape` that a facet with centre `middle` and unit normal `normal` represents: two
/// or three where the facet cuts off an edge or a corner. Their area vectors sum to that of the
/// facet. A smooth surface has one face, with the facet's normal. `h` is the spacing [m].
///
/// The first face is found along the normal, the next ones along the missing part of the area
/// vector.
template <int D>
std::vector<FaceOfFacet<D>> faces_of_facet(const Shape& shape, const Point<D>& middle,
                                           const Point<D>& normal, double h) {
  constexpr double same_face = 0.8;  // cosine; smooth surfaces turn less within a facet
  constexpr double little = 0.02;    // relative to the area of the facet
  using Vectors = Eigen::Matrix<double, D, D>;
  using Direction = Eigen::Matrix<double, D, 1>;
  const Direction whole = Eigen::Map<const Direction>(normal.data());
  Vectors normals = Vectors::Zero();
  Direction areas = Direction::Zero(), lacking = whole;
  int count = 0;
  while (count < D && lacking.norm() > little) {
    Point<D> along;
    Eigen::Map<Direction>(along.data()) = lacking.normalized();
    const Point<D> place = surface_place<D>(shape, middle, along, h).place;
    const Vector outward = outward_direction(shape, padded<D>(place), D);
    const Direction found = Eigen::Map<const Direction>(outward.data());
    if ((normals.transpose() * found).maxCoeff() > same_face) break;
    normals.col(count++) = found;
    const Vectors products = normals.transpose() * normals;
    areas = pseudo_inverse<D>(products) * (normals.transpose() * whole);
    lacking = whole - normals * areas;
  }
  if (count < 2 || areas.minCoeff() < -little) return {{normal}};
  std::vector<FaceOfFacet<D>> faces(count);
  for (int k = 0; k < count; ++k) {
    Eigen::Map<Direction>(faces[k].normal.data()) = normals.col(k);
    faces[k].area = std::max(areas[k], 0.);
  }
  return faces;
}

/// The loaded part of the surface that a facet represents, relative to the facet's area.
template <int D>
struct LoadedPart {
  double area = 0;
  Point<D> vector = {};  ///< area vector
  double gap = 0;        ///< from the facet to a surface with one face, along the normal [m]
};

/// The loaded part around the point `x` of a facet with unit normal `normal` and these faces.
/// `is_loaded(place)` tells whether the load acts at a place of the surface. If `shape` is null,
/// the facets are the surface.
template <int D, class F>
LoadedPart<D> loaded_part(const Shape* shape, const Point<D>& x, const Point<D>& normal,
                          const std::vector<FaceOfFacet<D>>& faces, double h, F&& is_loaded) {
  if (shape == nullptr) {
    if (!is_loaded(x)) return {};
    return {1, normal};
  }
  if (faces.size() == 1) {
    const SurfacePlace<D> at = surface_place<D>(*shape, x, normal, h);
    if (!is_loaded(at.place)) return {};
    double gap = 0;
    for (int a = 0; a < D; ++a) gap += (at.place[a] - x[a]) * normal[a];
    return {at.area, normal, gap};
  }
  LoadedPart<D> part;
  std::size_t count = 0;
  for (const FaceOfFacet<D>& face : faces) {
    if (!is_loaded(surface_place<D>(*shape, x, face.normal, h).place)) continue;
    ++count;
    part.area += face.area;
    for (int a = 0; a < D; ++a) part.vector[a] += face.area * face.normal[a];
  }
  if (count == faces.size()) part.vector = normal;
  return part;
}

}  // namespace pliant::undeformed

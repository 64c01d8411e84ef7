#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/lattice/column.hpp"
#include "engine/lattice/point_algebra.hpp"
#include "engine/remeshed/ghosts/initial_faces.hpp"
#include "engine/remeshed/loads/facet_parts.hpp"
#include "engine/remeshed/observe/surface_pieces.hpp"

namespace pliant::remeshed {

/// Finds the parts of facets, and the loads on them.
template <class T, int D>
class FacetLoads {
 public:
  FacetLoads(const LatticeView<T, D>& view, const Shape& surface, const Boundaries<D>& boundaries)
      : view_(view), surface_(surface), boundaries_(boundaries) {}

  FacetParts<D> of(const SurfacePiece<D>& piece) const {
    Corners corners;
    std::array<PlaceVector<D>, D> places;
    for (int i = 0; i < D; ++i) {
      corners[i] = start_of(piece[i]);
      places[i] = piece[i].place();
    }
    FacetParts<D> facet;
    const PlaceVector<D> area = area_of(places);
    if (area.norm() == 0) return facet;
    facet.normal = as_point<D>(area.normalized());
    std::array<InitialFace<D>, D> faces = {};
    facet.count = find_faces(corners, faces);
    for (int k = 0; k < facet.count; ++k) {
      FacetPart<D>& part = facet.parts[k];
      const auto [load, share] = facet.count == 1 ? load_on(corners) : load_on(corners, faces[k]);
      part.load = load;
      part.share = share;
      part.normal = present_normal<T, D>(view_.body.lattice, view_.population.layout, view_.fields,
                                         piece[0].inside->cell, faces[k].normal);
    }
    find_areas(facet);
    return facet;
  }

 private:
  using Corners = std::array<Point<D>, D>;
  static constexpr int samples = 16;  // along a facet

  // A facet that cuts off an edge belongs to two faces, or to three. Its area vector is the sum of
  // those of what it replaces of each, along their normals. The faces are those at its corners and
  // within half a spacing of them; one to which nothing of it belongs changes nothing. Normals that
  // are nearly in the plane of the others are left out, such as that of the other side of a slit.
  int find_faces(const Corners& corners, std::array<InitialFace<D>, D>& faces) const {
    constexpr double least_sine = 0.5;
    // Unit vectors that span the plane of the normals so far.
    std::array<Point<D>, D> directions = {};
    int count = 0;
    const auto add = [&](const Point<D>& place) {
      const InitialFace<D> found = face_at<D>(boundaries_, surface_, place);
      Point<D> rest = found.normal;
      for (int k = 0; k < count; ++k) {
        const double along = dot<D>(directions[k], found.normal);
        for (int a = 0; a < D; ++a) rest[a] -= along * directions[k][a];
      }
      const double sine = norm<D>(rest);
      if (sine < least_sine) return;
      for (int a = 0; a < D; ++a) directions[count][a] = rest[a] / sine;
      faces[count++] = found;
    };
    for (const Point<D>& corner : corners) add(corner);
    for (const Point<D>& corner : corners) {
      for (int a = 0; a < D; ++a) {
        for (const double way : {-0.5, 0.5}) {
          Point<D> beside = corner;
          beside[a] += way * view_.body.lattice.spacing;
          add(beside);
        }
      }
    }
    return count;
  }

  /// The areas of what the facet replaces of each face, along their normals.
  static void find_areas(FacetParts<D>& facet) {
    if (facet.count == 1) {
      facet.parts[0].area = facet.normal;
      return;
    }
    Eigen::Matrix<double, D, D> normals = Eigen::Matrix<double, D, D>::Identity();
    for (int k = 0; k < facet.count; ++k) normals.col(k) = column<D>(facet.parts[k].normal);
    if constexpr (D == 3) {
      if (facet.count == 2) normals.col(2) = normals.col(0).cross(normals.col(1));
    }
    const PlaceVector<D> along = normals.inverse() * column<D>(facet.normal);
    for (int k = 0; k < facet.count; ++k) {
      facet.parts[k].area = as_point<D>(along[k] * normals.col(k));
    }
  }

  struct PartialLoad {
    std::int8_t load;
    double share;
  };

  /// The load on a facet that belongs to one face.
  PartialLoad load_on(const Corners& corners) const {
    return load_where(corners, [this](const Point<D>& place) {
      return face_at<D>(boundaries_, surface_, place).load;
    });
  }

  /// The load on what a facet that cuts off an edge replaces of one of the faces there.
  PartialLoad load_on(const Corners& corners, const InitialFace<D>& face) const {
    return load_where(corners, [&](const Point<D>& place) {
      return load_at<D>(boundaries_, onto_plane<D>(face, place));
    });
  }

  // Where the loads at the corners differ, a region ends on the facet.
  template <class LoadAt>
  PartialLoad load_where(const Corners& corners, LoadAt&& load_at_place) const {
    std::int8_t load = no_load;
    bool ends = false;
    for (int i = 0; i < D; ++i) {
      const std::int8_t at_corner = load_at_place(corners[i]);
      ends = ends || (i > 0 && at_corner != load);
      load = std::max(load, at_corner);
    }
    if (!ends) return {load, 1};
    int under = 0, count = 0;
    for_each_sample(corners, [&](const Point<D>& place) {
      ++count;
      under += load_at_place(place) == load ? 1 : 0;
    });
    return {load, static_cast<double>(under) / count};
  }

  /// Calls f(place) for places that share a segment or triangle in equal parts.
  template <class F>
  static void for_each_sample(const std::array<Point<D>, D>& corners, F&& f) {
    for (int i = 0; i < samples; ++i) {
      const double r = (i + 0.5) / samples;
      if constexpr (D == 2) {
        f(mean_of(corners, {1 - r, r}));
      } else {
        for (int j = 0; j < samples; ++j) {
          const double s = (j + 0.5) / samples, root = std::sqrt(r);
          f(mean_of(corners, {1 - root, root * (1 - s), root * s}));
        }
      }
    }
  }

  static Point<D> mean_of(const std::array<Point<D>, D>& corners,
                          const std::array<double, D>& weights) {
    Point<D> place = {};
    for (int i = 0; i < D; ++i) {
      for (int a = 0; a < D; ++a) place[a] += weights[i] * corners[i][a];
    }
    return place;
  }

  Point<D> start_of(const Crossing<D>& crossing) const {
    const double fraction = crossing.fraction();
    const PlaceVector<D> place = crossing.place();
    Point<D> start;
    for (int a = 0; a < D; ++a) {
      const T* moved = view_.fields.get(Field::displacement, a);
      start[a] = place[a] - (1 - fraction) * moved[crossing.inside->slot] -
                 fraction * moved[crossing.outside->slot];
    }
    return start;
  }

  const LatticeView<T, D>& view_;
  const Shape& surface_;
  const Boundaries<D>& boundaries_;
};

}  // namespace pliant::remeshed

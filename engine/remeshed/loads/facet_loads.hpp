#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/lattice/column.hpp"
#include "engine/lattice/point_algebra.hpp"
#include "engine/remeshed/ghosts/record_loads.hpp"
#include "engine/remeshed/observe/surface_pieces.hpp"

namespace pliant::remeshed {

/// The loads on the components of a facet's area vector along `normal`, and the share of the facet
/// on which they act.
template <int D>
struct FacetLoad {
  std::array<std::int8_t, D> load;
  std::array<Point<D>, D> normal = axes();
  double share = 1;
  int faces = 1;  ///< to which the facet belongs; the first ones of `normal` if several

  static constexpr std::array<Point<D>, D> axes() {
    std::array<Point<D>, D> axes = {};
    for (int a = 0; a < D; ++a) axes[a][a] = 1;
    return axes;
  }
};

/// Components of an area vector along the normals of a facet's faces.
template <int D>
PlaceVector<D> along_faces(const PlaceVector<D>& area, const std::array<Point<D>, D>& normals) {
  Eigen::Matrix<double, D, D> columns;
  for (int i = 0; i < D; ++i) columns.col(i) = column<D>(normals[i]);
  return columns.inverse() * area;
}

/// Finds the loads on facets.
template <class T, int D>
class FacetLoads {
 public:
  FacetLoads(const LatticeView<T, D>& view, const Shape& surface, const Boundaries<D>& boundaries)
      : view_(view), surface_(surface), boundaries_(boundaries) {}

  FacetLoad<D> of(const SurfacePiece<D>& piece) const {
    std::array<InitialFace<D>, D> faces;
    for (int i = 0; i < D; ++i) faces[i] = face(start_of(piece[i]));
    const auto [least, greatest] = std::ranges::minmax(faces, {}, &InitialFace<D>::load);
    if (least.load != greatest.load && is_one_face(faces)) {
      FacetLoad<D> result;
      result.load.fill(greatest.load);
      result.share = share_under(greatest.load, piece);
      return result;
    }
    return of_faces(piece, faces);
  }

 private:
  static constexpr int samples = 16;  // along a facet

  static bool is_one_face(const std::array<InitialFace<D>, D>& faces) {
    return std::ranges::all_of(faces, [&](const InitialFace<D>& face) {
      return dot<D>(face.normal, faces[0].normal) > one_face;
    });
  }

  // A facet that cuts off an edge belongs to two faces, or to three. Its area vector is the sum of
  // those of what it replaces of each, along their normals. The faces are those at its corners and
  // within half a spacing of them; one to which nothing of it belongs changes nothing. Normals that
  // are nearly in the plane of the others are left out, such as that of the other side of a slit.
  FacetLoad<D> of_faces(const SurfacePiece<D>& piece,
                        const std::array<InitialFace<D>, D>& at_corners) const {
    constexpr double least_sine = 0.5;
    std::array<InitialFace<D>, D> faces = {};
    // Unit vectors that span the plane of the normals so far.
    std::array<Point<D>, D> directions = {};
    int count = 0;
    const auto add = [&](const InitialFace<D>& face) {
      Point<D> rest = face.normal;
      for (int k = 0; k < count; ++k) {
        const double along = dot<D>(directions[k], face.normal);
        for (int a = 0; a < D; ++a) rest[a] -= along * directions[k][a];
      }
      const double sine = norm<D>(rest);
      if (sine < least_sine) return;
      for (int a = 0; a < D; ++a) directions[count][a] = rest[a] / sine;
      faces[count++] = face;
    };
    for (const InitialFace<D>& face : at_corners) add(face);
    for (const Crossing<D>& crossing : piece) {
      const Point<D> start = start_of(crossing);
      for (int a = 0; a < D; ++a) {
        for (const double way : {-0.5, 0.5}) {
          Point<D> beside = start;
          beside[a] += way * view_.body.lattice.spacing;
          add(face(beside));
        }
      }
    }
    FacetLoad<D> result;
    result.load.fill(faces[0].load);
    result.faces = count;
    if (count == 1) return result;
    for (int k = 0; k < count; ++k) {
      result.load[k] = faces[k].load;
      result.normal[k] = present_normal<T, D>(view_.body.lattice, view_.population.layout,
                                              view_.fields, piece[0].inside->cell, faces[k].normal);
    }
    if constexpr (D == 3) {
      if (count == 2) {
        const auto [a, b, rest] = result.normal;
        result.normal[2] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                            a[0] * b[1] - a[1] * b[0]};
        result.load[2] = no_load;
      }
    }
    return result;
  }

  // The region of the load ends on this facet.
  double share_under(std::int8_t load, const SurfacePiece<D>& piece) const {
    std::array<Point<D>, D> corners;
    for (int i = 0; i < D; ++i) corners[i] = start_of(piece[i]);
    int under = 0, count = 0;
    for_each_sample(corners, [&](const Point<D>& place) {
      ++count;
      under += face(place).load == load ? 1 : 0;
    });
    return static_cast<double>(under) / count;
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

  InitialFace<D> face(const Point<D>& start) const {
    return face_at<D>(boundaries_, surface_, start);
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

#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/remeshed/ghosts/record_loads.hpp"
#include "engine/remeshed/observe/surface_pieces.hpp"

namespace pliant::remeshed {

/// The loads on the components of a facet's area vector, and the share of the facet on which they
/// act.
template <int D>
struct FacetLoad {
  std::array<std::int8_t, D> load;
  double share = 1;
};

/// Finds the loads on facets.
template <class T, int D>
class FacetLoads {
 public:
  FacetLoads(const LatticeView<T, D>& view, const Shape& surface, const Boundaries<D>& boundaries)
      : view_(view), surface_(surface), boundaries_(boundaries) {}

  FacetLoad<D> of(const SurfacePiece<D>& piece) const {
    std::array<InitialFace<D>, D> faces;
    for (int i = 0; i < D; ++i) faces[i] = face(start_of(piece[i]));
    FacetLoad<D> result;
    const auto [least, greatest] = std::ranges::minmax(faces, {}, &InitialFace<D>::load);
    if (least.load != greatest.load && is_one_face(faces)) {
      result.load.fill(greatest.load);
      result.share = share_under(greatest.load, piece);
      return result;
    }
    for (int a = 0; a < D; ++a) result.load[a] = along(piece, a);
    return result;
  }

 private:
  static constexpr double one_face = 0.8;  // cosine between normals of one face
  static constexpr int samples = 16;       // along a facet

  static bool is_one_face(const std::array<InitialFace<D>, D>& faces) {
    return std::ranges::all_of(faces, [&](const InitialFace<D>& face) {
      double cosine = 0;
      for (int a = 0; a < D; ++a) cosine += face.normal[a] * faces[0].normal[a];
      return cosine > one_face;
    });
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

  // A facet that cuts off an edge belongs to two faces. A component along an axis then belongs to
  // the face that a particle of the facet sees along that axis.
  std::int8_t along(const SurfacePiece<D>& piece, int axis) const {
    for (const Crossing<D>& crossing : piece) {
      const int step = crossing.outside->cell[axis] - crossing.inside->cell[axis];
      if (step == 0) continue;
      SurfaceNode<D> beyond = *crossing.inside;
      beyond.cell[axis] += step;
      beyond.slot = view_.population.layout.slot(view_.body.lattice.wrapped(beyond.cell));
      beyond.phi = view_.fields.get(Field::level_set)[beyond.slot];
      beyond.place[axis] += step * view_.body.lattice.spacing;
      if (beyond.phi >= 0) return face(start_of(Crossing<D>{crossing.inside, &beyond})).load;
    }
    return face(start_of(piece[0])).load;
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

#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "engine/lattice/point_algebra.hpp"
#include "engine/lattice/tangents.hpp"
#include "engine/remeshed/ghosts/initial_faces.hpp"

namespace pliant::remeshed {

/// Finds the faces of the surface near the particles and ghosts of a block, and the loads there.
template <class T, int D>
class LoadFinder {
 public:
  LoadFinder(const Lattice<D>& lattice, const Layout<D>& layout, const FieldStore<T, D>& fields,
             const Shape& surface, const Boundaries<D>& boundaries)
      : surface_(surface),
        lattice_(lattice),
        layout_(layout),
        fields_(fields),
        boundaries_(boundaries) {}

  /// Finds the load on the particle of a record, its share, the normal of its face, and grad phi.
  void find(std::int32_t record, Population<T, D>& population) const {
    const std::int64_t slot = population.slot_of_record[record];
    const Cell<D> cell = layout_.cell(slot);
    const auto [initial, around] = nearest_face(start_of(slot));
    population.load[record] = around.load;
    population.loaded_share[record] = static_cast<T>(around.share);
    const Point<D> normal = present_normal<T, D>(lattice_, layout_, fields_, cell, initial.normal);
    const Point<D> gradient = slope_at(cell, initial.normal);
    for (int a = 0; a < D; ++a) {
      population.face[record][a] = static_cast<T>(normal[a]);
      population.slope[record][a] = static_cast<T>(gradient[a]);
    }
  }

  using Faces = std::array<InitialFace<D>, D>;

  /// Lists the faces near a ghost, their loads and the shares of these. `inside` is the slot of a
  /// particle near it.
  void find_faces(std::size_t ghost, std::int64_t inside, BlockGhosts<T, D>& ghosts) const {
    Faces faces;
    const InitialFace<D> nearest = face_at<D>(boundaries_, surface_, start_of(ghosts.slot[ghost]));
    const int count = faces_near(nearest, faces);
    for (int i = 0; i < count; ++i) {
      const std::size_t k = ghost * D + i;
      const Point<D> normal =
          present_normal<T, D>(lattice_, layout_, fields_, layout_.cell(inside), faces[i].normal);
      for (int a = 0; a < D; ++a) ghosts.face[k][a] = static_cast<T>(normal[a]);
      const auto [load, share] = load_around(faces[i], nearest.place);
      ghosts.face_load[k] = load;
      ghosts.face_share[k] = static_cast<T>(share);
    }
  }

 private:
  static constexpr double known = 0.02;     // [h] accuracy of places at t = 0
  static constexpr int samples = 8;         // along a spacing of a face where a region ends
  static constexpr double rounding = 1e-9;  // of distances in spacings

  /// The faces near a place on the surface, and their number. Places inside the body see them,
  /// without the directions in between at edges.
  int faces_near(const InitialFace<D>& nearest, Faces& faces) const {
    constexpr double below = 0.7, beside = 0.3;  // [h]
    int count = 0;
    const auto add = [&](const Point<D>& x) {
      const InitialFace<D> face = face_at<D>(boundaries_, surface_, x);
      for (int i = 0; i < count; ++i) {
        if (dot<D>(faces[i].normal, face.normal) > one_face) return;
      }
      if (count < D) faces[count++] = face;
    };
    Point<D> middle = nearest.place;
    for (int a = 0; a < D; ++a) middle[a] -= below * lattice_.spacing * nearest.normal[a];
    add(middle);
    for (int a = 0; a < D; ++a) {
      for (const double way : {-beside, beside}) {
        Point<D> x = middle;
        x[a] += way * lattice_.spacing;
        add(x);
      }
    }
    return count;
  }

  struct PartialLoad {
    std::int8_t load;
    double share;  ///< of the area on which it acts
  };

  struct LoadedFace {
    InitialFace<D> face;
    PartialLoad around;

    double share() const { return around.load < 0 ? 0 : around.share; }
  };

  // A load, and on how much of a face it acts: of the spacing (in 3D its square) of the face
  // nearest to `centre`. Where a region ends, that is a part. Beyond an edge of the body the face
  // does not continue; the loads on its last spacing are those at the edge.
  PartialLoad load_around(const InitialFace<D>& face, const Point<D>& centre) const {
    const Point<D> middle = onto_plane<D>(face, centre);
    const std::int8_t load = load_at<D>(boundaries_, middle);
    bool ends = false;
    for_each_place(face.normal, middle, 2, [&](const Point<D>& x, double) {
      ends = ends || load_at<D>(boundaries_, x) != load;
    });
    if (!ends) return {load, 1};
    std::array<Sample, D == 2 ? 2 * samples : 4 * samples * samples> on_face;
    std::size_t count = 0;
    for_each_place(face.normal, middle, samples, [&](const Point<D>& x, double distance) {
      const InitialFace<D> beside = face_at<D>(boundaries_, surface_, x);
      if (dot<D>(beside.normal, face.normal) > one_face) on_face[count++] = {distance, beside.load};
    });
    return count == 0 ? PartialLoad{load, 1} : load_of_nearest(std::span(on_face).first(count));
  }

  struct Sample {
    double distance;  ///< [h]
    std::int8_t load;
  };

  /// The load on those samples that are as many as those of one spacing, or all.
  static PartialLoad load_of_nearest(std::span<Sample> on_face) {
    std::ranges::sort(on_face, {}, &Sample::distance);
    const std::size_t of_spacing = D == 2 ? samples : samples * samples;
    const double reach = on_face[std::min(of_spacing, on_face.size()) - 1].distance;
    PartialLoad found{no_load, 1};
    int count = 0, loaded = 0;
    for (const Sample& sample : on_face) {
      if (sample.distance > reach + rounding) break;
      ++count;
      if (sample.load < 0) continue;
      ++loaded;
      if (found.load < 0) found.load = sample.load;
    }
    if (loaded > 0) found.share = static_cast<double>(loaded) / count;
    return found;
  }

  /// Calls f(place, distance) for places of a plane within a spacing of `middle` along each of its
  /// directions, `number` for each spacing, and their distance along these in spacings.
  template <class F>
  void for_each_place(const Point<D>& normal, const Point<D>& middle, int number, F&& f) const {
    const auto along = tangents<D>(column<D>(normal));
    const auto offset = [&](int i) { return (i + 0.5) / number - 1; };
    for (int i = 0; i < 2 * number; ++i) {
      for (int j = 0; j < (D == 3 ? 2 * number : 1); ++j) {
        Point<D> x = middle;
        for (int a = 0; a < D; ++a) {
          x[a] += offset(i) * lattice_.spacing * along(a, 0);
          if constexpr (D == 3) x[a] += offset(j) * lattice_.spacing * along(a, 1);
        }
        f(x, std::max(std::abs(offset(i)), D == 3 ? std::abs(offset(j)) : 0));
      }
    }
  }

  // For a place on the bisector of an edge, rounding would decide which face is nearest: the one
  // with more load is preferred.
  LoadedFace nearest_face(const Point<D>& start) const {
    LoadedFace nearest = with_load(face_at<D>(boundaries_, surface_, start));
    for (int a = 0; a < D && nearest.share() < 1; ++a) {
      for (const double way : {-known, known}) {
        Point<D> beside = start;
        beside[a] += way * lattice_.spacing;
        const InitialFace<D> face = face_at<D>(boundaries_, surface_, beside);
        if (dot<D>(face.normal, nearest.face.normal) > one_face) continue;
        const LoadedFace other = with_load(face);
        if (other.share() > nearest.share()) nearest = other;
      }
    }
    return nearest;
  }

  LoadedFace with_load(const InitialFace<D>& face) const {
    return {face, load_around(face, face.place)};
  }

  // grad phi, or the initial normal where a node beside has no slot.
  Point<D> slope_at(const Cell<D>& cell, const Point<D>& initial) const {
    const T* phi = fields_.get(Field::level_set);
    Point<D> slope = initial;
    for_each_pair_beside<D>(lattice_, layout_, cell, [&](int a, std::int64_t q, std::int64_t r) {
      slope[a] = (phi[q] - phi[r]) / (2 * lattice_.spacing);
    });
    return slope;
  }

  /// Place at t = 0 of the material in a slot.
  Point<D> start_of(std::int64_t slot) const {
    Point<D> start = lattice_.node(layout_.cell(slot));
    for (int a = 0; a < D; ++a) start[a] -= fields_.get(Field::displacement, a)[slot];
    return start;
  }

  const Shape& surface_;
  const Lattice<D>& lattice_;
  const Layout<D>& layout_;
  const FieldStore<T, D>& fields_;
  const Boundaries<D>& boundaries_;
};

}  // namespace pliant::remeshed
